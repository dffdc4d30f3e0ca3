// SPDX-License-Identifier: Apache-2.0
#include "record/checkpoint.h"

#include "record/table.h"
#include "world/flow.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEDGER_COLUMNS = 6, RUN_COLUMNS = 3, CLASS_COLUMNS = 4 };

// ---- Columns of each group -----------------------------------------------------------------------

// The tables of a state: fields, group in the file, how many rows.
#define STATE_TABLES(T)                                            \
    T(QN_PARTICLE_FIELDS, "particles", count)                      \
    T(QN_CONTACT_FIELDS, "contacts", contact_count)                \
    T(QN_WALL_CONTACT_FIELDS, "wall_contacts", wall_contact_count) \
    T(QN_BODY_FIELDS, "bodies", body_count)

/// Writes (`read` false) or reads the arrays of a state.
static qn_status move_state(hid_t file, const qn_state *s, bool read)
{
#define F(type, name, width, unit, meaning) \
    {#name, unit, meaning, QN_TYPE_OF(*s->name), width, rows, s->name},
#define T(FIELDS, group, number)                                           \
    {                                                                      \
        int64_t rows = s->number;                                          \
        qn_column columns[] = {FIELDS(F)};                                 \
        int count = (int)(sizeof columns / sizeof *columns);               \
        QN_TRY(read ? qn_table_read(file, group, columns, count)           \
                    : qn_table_write(file, group, columns, count, false)); \
    }
    STATE_TABLES(T)
#undef T
#undef F
    return QN_OK;
}

/// Writes or reads what the measures keep.
static qn_status move_measure(hid_t file, qn_measure *measure, bool read)
{
    qn_column *columns;
    int count = qn_measure_columns(measure, NULL, 0);
    QN_TRY(QN_ALLOCATE(columns, count));
    qn_measure_columns(measure, columns, count);
    qn_status status = read ? qn_table_read(file, "measure", columns, count)
                            : qn_table_write(file, "measure", columns, count, false);
    free(columns);
    return status;
}

static void ledger_columns(const qn_ledger *l, qn_column *out)
{
    qn_ledger *w = (qn_ledger *)l;  // columns are written to on reading back only
    out[0] =
        (qn_column){"lost",    "J", "lost to each channel since step 0, in the order of `names`",
                    QN_DOUBLE, 1,   QN_LOSS_COUNT,
                    w->lost};
    out[1] = (qn_column){"work",    "J", "done by each part of the walls since step 0",
                         QN_DOUBLE, 1,   w->part_count,
                         w->work};
    out[2] = (qn_column){"impulse", "N m s", "torque of each part about the axis times time",
                         QN_DOUBLE, 1,       w->part_count,
                         w->impulse};
    out[3] = (qn_column){"deepest", "1",        "largest overlap so far in radii", QN_DOUBLE, 1,
                         1,         &w->deepest};
    out[4] = (qn_column){"deepest_step",  "1", "step of the largest overlap", QN_INT64, 1, 1,
                         &w->deepest_step};
    out[5] = (qn_column){"push",        "N s",  "force of each part times time", QN_DOUBLE, 3,
                         w->part_count, w->push};
}

/// What the walls' facets have suffered, each sum as low + 2^61 high quanta.
static qn_status move_wear(hid_t file, const qn_world *w, bool read)
{
    qn_wear *wear = (qn_wear *)&w->wear;  // as above; settling changes the form of a sum only
    int64_t rows = wear->facet_count;
    if (rows == 0) return QN_OK;
    const int width = 2 * QN_WEAR_COUNT;
    const qn_column column = {"sums",      "1",   "low words, then high words, of each sum",
                              QN_INT64,    width, rows,
                              wear->facets};
    if (read) return qn_table_read(file, "wear", &column, 1);
    qn_wear_settle(wear);
    return qn_table_write(file, "wear", &column, 1, true);
}

static void run_columns(qn_progress *p, int64_t *started, qn_column *out)
{
    out[0] = (qn_column){"wall", "s", "wall time spent computing", QN_DOUBLE, 1, 1, &p->wall};
    out[1] = (qn_column){"started", "1",    "whether velocities are half a step back", QN_INT64, 1,
                         1,         started};
    out[2] = (qn_column){"frame_steps",  "1",           "step of each frame written", QN_INT64, 1,
                         p->frame_count, p->frame_steps};
}

/// Writes or reads what feeds and outlets have done, where there are any.
static qn_status move_flow(hid_t file, const qn_world *w, bool read)
{
    qn_column columns[QN_FLOW_COLUMNS];
    if (!w->flow) return QN_OK;
    int count = qn_flow_columns(w->flow, columns);
    return read ? qn_table_read(file, "flow", columns, count)
                : qn_table_write(file, "flow", columns, count, false);
}

/// The class table as columns over one block of memory (owned by the caller).
typedef struct class_table {
    double *numbers;
    qn_column columns[CLASS_COLUMNS];
} class_table;

static qn_status class_columns(const qn_world *w, bool fill, class_table *t)
{
    static const char *const names[CLASS_COLUMNS][3] = {{"radius", "m", "of the particles"},
                                                        {"mass", "kg", "of one particle"},
                                                        {"inertia", "kg m2", "of one particle"},
                                                        {"inverse_mass", "1/kg", "0 where fixed"}};
    int64_t rows = w->class_count;
    QN_TRY(QN_ALLOCATE(t->numbers, CLASS_COLUMNS * rows));
    for (int c = 0; c < CLASS_COLUMNS; c++)
        t->columns[c] = (qn_column){names[c][0], names[c][1], names[c][2],          QN_DOUBLE,
                                    1,           rows,        t->numbers + c * rows};
    for (int i = 0; fill && i < w->class_count; i++) {
        const qn_class *k = &w->classes[i];
        double row[CLASS_COLUMNS] = {k->radius, k->mass, k->inertia, k->inverse_mass};
        for (int c = 0; c < CLASS_COLUMNS; c++) t->numbers[c * rows + i] = row[c];
    }
    return QN_OK;
}

// ---- Writing -------------------------------------------------------------------------------------

static qn_status put_classes(hid_t file, const qn_world *w)
{
    class_table table;
    hid_t group;
    char(*names)[QN_NAME_MAX];
    QN_TRY(class_columns(w, true, &table));
    qn_status status = qn_table_write(file, "classes", table.columns, CLASS_COLUMNS, false);
    free(table.numbers);
    if (status == QN_OK) status = QN_ALLOCATE(names, w->class_count);
    if (status != QN_OK) return status;
    for (int i = 0; i < w->class_count; i++)
        memcpy(names[i], w->def.materials[w->classes[i].material].name, QN_NAME_MAX);
    status = qn_h5_group_open(file, "classes", &group);
    if (status == QN_OK) {
        status = qn_h5_put_names(group, "materials", names[0], QN_NAME_MAX, w->class_count);
        H5Gclose(group);
    }
    free(names);
    return status;
}

static qn_status put_ledger(hid_t file, const qn_ledger *ledger)
{
    static const char names[][QN_NAME_MAX] = {
#define C(NAME, name, unit, meaning) #name,
        QN_LOSSES(C)
#undef C
    };
    qn_column columns[LEDGER_COLUMNS];
    hid_t group;
    ledger_columns(ledger, columns);
    QN_TRY(qn_table_write(file, "ledger", columns, LEDGER_COLUMNS, false));
    QN_TRY(qn_h5_group_open(file, "ledger", &group));
    qn_status status = qn_h5_put_names(group, "names", names[0], QN_NAME_MAX, QN_LOSS_COUNT);
    H5Gclose(group);
    return status;
}

static qn_status put_about(hid_t file, const qn_world *w, const qn_progress *p)
{
    QN_TRY(qn_h5_put_text(file, "format", QN_CHECKPOINT_FORMAT));
    QN_TRY(qn_h5_put_text(file, "version", QN_VERSION));
    QN_TRY(qn_h5_put_text(file, "title", w->def.title));
    QN_TRY(qn_h5_put_integer(file, "step", w->step));
    QN_TRY(qn_h5_put_number(file, "time", qn_world_time(w)));
    QN_TRY(qn_h5_put_number(file, "dt", w->dt));
    QN_TRY(qn_h5_put_integer(file, "scene_hash", (int64_t)p->scene_hash));
    return qn_h5_put_integer(file, "state_hash", (int64_t)p->state_hash);
}

static qn_status put_all(hid_t file, const qn_world *w, const qn_state *state, qn_measure *measure,
                         qn_progress *p)
{
    qn_column run[RUN_COLUMNS];
    int64_t started = w->started;
    run_columns(p, &started, run);
    QN_TRY(put_about(file, w, p));
    QN_TRY(move_state(file, state, false));
    QN_TRY(put_classes(file, w));
    QN_TRY(put_ledger(file, &w->ledger));
    QN_TRY(move_wear(file, w, false));
    QN_TRY(move_flow(file, w, false));
    QN_TRY(move_measure(file, measure, false));
    return qn_table_write(file, "run", run, RUN_COLUMNS, false);
}

qn_status qn_checkpoint_write(const char *path, const qn_world *world, qn_measure *measure,
                              qn_progress *progress)
{
    qn_state state = {0};
    hid_t file;
    QN_TRY(qn_world_export(world, &state));
    progress->state_hash = qn_state_hash(&state);
    qn_status status = qn_h5_begin(&file);
    if (status == QN_OK) {
        status = put_all(file, world, &state, measure, progress);
        if (status == QN_OK)
            status = qn_h5_commit(file, path);
        else
            qn_h5_close(file);
    }
    qn_state_free(&state);
    return status;
}

// ---- Reading -------------------------------------------------------------------------------------

static qn_status check_about(hid_t file, const qn_world *w, const qn_progress *p)
{
    char format[64];
    int64_t scene_hash;
    double dt;
    QN_TRY(qn_h5_get_text(file, "format", format, sizeof format));
    QN_TRY(qn_h5_get_integer(file, "scene_hash", &scene_hash));
    QN_TRY(qn_h5_get_number(file, "dt", &dt));
    if (strcmp(format, QN_CHECKPOINT_FORMAT) != 0)
        return qn_fail(QN_INPUT, "its format is \"%s\", this program reads \"%s\"", format,
                       QN_CHECKPOINT_FORMAT);
    if ((uint64_t)scene_hash != p->scene_hash)
        return qn_fail(QN_INPUT, "it is of another scene than the one given; go on with the "
                                 "scene it was made from");
    if (dt != w->dt)
        return qn_fail(QN_INPUT, "its time step is %.17g s, that of this run %.17g s", dt, w->dt);
    return QN_OK;
}

static qn_status check_classes(hid_t file, const qn_world *w)
{
    class_table mine, table;
    QN_TRY(class_columns(w, true, &mine));
    qn_status status = class_columns(w, false, &table);
    if (status == QN_OK) {
        status = qn_table_read(file, "classes", table.columns, CLASS_COLUMNS);
        size_t bytes = sizeof(double) * CLASS_COLUMNS * (size_t)w->class_count;
        if (status == QN_OK && memcmp(mine.numbers, table.numbers, bytes) != 0)
            status = qn_fail(QN_INPUT, "its particle classes are not those of this run");
        free(table.numbers);
    }
    free(mine.numbers);
    return status;
}

static qn_status get_state(hid_t file, qn_world *w, qn_progress *p)
{
    qn_state s = {0};
    int64_t hash;
    QN_TRY(qn_h5_get_integer(file, "step", &s.step));
    QN_TRY(qn_h5_get_integer(file, "state_hash", &hash));
    QN_TRY(qn_table_rows(file, "particles", "id", &s.count));
    QN_TRY(qn_table_rows(file, "contacts", "low", &s.contact_count));
    QN_TRY(qn_table_rows(file, "wall_contacts", "wall_id", &s.wall_contact_count));
    QN_TRY(qn_table_rows(file, "bodies", "body_id", &s.body_count));
    if (s.count != w->count && !w->flow)
        return qn_fail(QN_INPUT, "it holds %lld particles, this run has %d", (long long)s.count,
                       w->count);
    QN_TRY(qn_state_allocate(&s));
    qn_status status = move_state(file, &s, true);
    if (status == QN_OK && qn_state_hash(&s) != (uint64_t)hash)
        status = qn_fail(QN_IO, "it is damaged: its state is not the one that was written");
    if (status == QN_OK) status = qn_world_import(w, &s);
    if (status == QN_OK) p->state_hash = (uint64_t)hash;
    qn_state_free(&s);
    return status;
}

static qn_status get_run(hid_t file, qn_world *w, qn_progress *p)
{
    qn_column columns[RUN_COLUMNS];
    int64_t started = 0, frames;
    QN_TRY(qn_table_rows(file, "run", "frame_steps", &frames));
    QN_TRY(QN_RESERVE(p->frame_steps, p->frame_room, frames));
    p->frame_count = frames;
    run_columns(p, &started, columns);
    QN_TRY(qn_table_read(file, "run", columns, RUN_COLUMNS));
    w->started = started != 0;
    return QN_OK;
}

static qn_status get_all(hid_t file, qn_world *w, qn_measure *measure, qn_progress *p)
{
    qn_column ledger[LEDGER_COLUMNS];
    QN_TRY(check_about(file, w, p));
    QN_TRY(check_classes(file, w));
    QN_TRY(get_state(file, w, p));
    ledger_columns(&w->ledger, ledger);
    QN_TRY(qn_table_read(file, "ledger", ledger, LEDGER_COLUMNS));
    QN_TRY(move_wear(file, w, true));
    QN_TRY(move_flow(file, w, true));
    QN_TRY(move_measure(file, measure, true));
    return get_run(file, w, p);
}

qn_status qn_checkpoint_read(const char *path, qn_world *world, qn_measure *measure,
                             qn_progress *progress)
{
    hid_t file;
    char reason[1024];
    QN_TRY(qn_h5_open(path, &file));
    qn_status status = get_all(file, world, measure, progress);
    qn_h5_close(file);
    if (status == QN_OK || status == QN_MEMORY) return status;
    snprintf(reason, sizeof reason, "%s", qn_error());
    return qn_fail(status, "%s can't be used: %s", path, reason);
}
