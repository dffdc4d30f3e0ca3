// SPDX-License-Identifier: Apache-2.0
#include "record/traces.h"

#include "step/step.h"

#include <stdlib.h>

// What a row of traces.csv holds: w the world, i the particle, x, v, s, a its position, velocity, spin
// and force; of trace_contacts.csv: r the reply of the contact, p the contact point.
// clang-format off
#define PARTICLE_COLUMNS(C)                                        \
    C("x_m", x.x) C("y_m", x.y) C("z_m", x.z)                      \
    C("vx_m_s", v.x) C("vy_m_s", v.y) C("vz_m_s", v.z)             \
    C("wx_rad_s", s.x) C("wy_rad_s", s.y) C("wz_rad_s", s.z)       \
    C("fx_n", f.x) C("fy_n", f.y) C("fz_n", f.z)
#define CONTACT_COLUMNS(C)                                         \
    C("depth_m", r->depth) C("elastic_n", r->elastic)              \
    C("damping_n", r->damping) C("normal_n", r->push)              \
    C("tangential_x_n", r->tangential.x)                           \
    C("tangential_y_n", r->tangential.y)                           \
    C("tangential_z_n", r->tangential.z)                           \
    C("normal_x", r->normal.x) C("normal_y", r->normal.y)          \
    C("normal_z", r->normal.z)                                     \
    C("point_x_m", p.x) C("point_y_m", p.y) C("point_z_m", p.z)    \
    C("stored_normal_j", r->stored_normal)                         \
    C("stored_tangential_j", r->stored_tangential)
// clang-format on

#define HEADER(name, value) "," name

qn_status qn_traces_open(qn_traces *traces, const char *folder, const qn_measure_def *def,
                         int64_t cut)
{
    char path[QN_FILE_NAME_MAX];
    *traces = (qn_traces){0};
    if (def->traced_count == 0) return QN_OK;
    QN_TRY(qn_series_file_open(&traces->particles, qn_path_join(path, folder, "traces.csv"),
                               "step,time_s,id" PARTICLE_COLUMNS(HEADER), cut));
    return qn_series_file_open(&traces->contacts, qn_path_join(path, folder, "trace_contacts.csv"),
                               "step,time_s,id,partner" CONTACT_COLUMNS(HEADER), cut);
}

static void begin_row(qn_series_file *file, const qn_world *w, int64_t id)
{
    qn_series_file_integer(file, w->step);
    qn_series_file_number(file, qn_world_time(w));
    qn_series_file_integer(file, id);
}

/// Force (N) on particle i from contacts and walls, without gravity.
static qn_vec3 force_on(const qn_world *w, int i)
{
    const int64_t *load = w->load[i].force;
    return qn_scale(w->classes[w->place[i].klass].force_unit,
                    qn_v3((double)load[0], (double)load[1], (double)load[2]));
}

static void write_particle(qn_series_file *file, const qn_world *w, int i)
{
    qn_vec3 x = qn_world_position(w, i), v = qn_velocity_now(w, i), s = qn_spin_now(w, i);
    qn_vec3 f = force_on(w, i);
    begin_row(file, w, w->id[i]);
#define C(name, value) qn_series_file_number(file, value);
    PARTICLE_COLUMNS(C)
#undef C
    qn_series_file_end_row(file);
}

/// The contacts of one particle, gathered to be put in order: the world's own order depends on its
/// list.
typedef struct touch {
    int64_t partner;
    qn_reply reply;
    qn_vec3 point;
} touch;

typedef struct gathered {
    touch *touches;  // owned
    int64_t count, room;
    qn_status status;
} gathered;

/// Keeps a contact in its place: walls by part, then particles by id.
static void gather(void *user, int64_t id, int64_t partner, const qn_reply *r, qn_vec3 p)
{
    gathered *g = user;
    (void)id;
    if (g->status == QN_OK) g->status = QN_RESERVE(g->touches, g->room, g->count + 1);
    if (g->status != QN_OK) return;
    int64_t k = g->count++;
    for (; k > 0 && g->touches[k - 1].partner > partner; k--) g->touches[k] = g->touches[k - 1];
    g->touches[k] = (touch){partner, *r, p};
}

static void write_contact(qn_series_file *file, const qn_world *w, int64_t id, const touch *t)
{
    const qn_reply *r = &t->reply;
    qn_vec3 p = t->point;
    begin_row(file, w, id);
    if (t->partner < 0)
        qn_series_file_word(file, w->walls.parts[-1 - t->partner].name);
    else
        qn_series_file_integer(file, t->partner);
#define C(name, value) qn_series_file_number(file, value);
    CONTACT_COLUMNS(C)
#undef C
    qn_series_file_end_row(file);
}

qn_status qn_traces_write(qn_traces *traces, qn_world *world, const qn_measure_def *def)
{
    gathered g = {.status = QN_OK};
    qn_status status = QN_OK;
    for (int t = 0; t < def->traced_count && status == QN_OK; t++) {
        int i = 0;
        while (i < world->count && world->id[i] != def->traced[t]) i++;
        if (i == world->count) continue;
        write_particle(&traces->particles, world, i);
        g.count = 0;
        status = qn_step_visit(world, def->traced[t], gather, &g);
        if (status == QN_OK) status = g.status;
        for (int64_t k = 0; k < g.count; k++)
            write_contact(&traces->contacts, world, def->traced[t], &g.touches[k]);
    }
    free(g.touches);
    return status;
}

qn_status qn_traces_sync(qn_traces *traces)
{
    QN_TRY(qn_series_file_sync(&traces->particles));
    return qn_series_file_sync(&traces->contacts);
}

void qn_traces_close(qn_traces *traces)
{
    qn_series_file_close(&traces->particles);
    qn_series_file_close(&traces->contacts);
}
