// SPDX-License-Identifier: Apache-2.0
#include "step/flow.h"
#include "base/random.h"
#include "world/occupied.h"
#include "world/population.h"

#include <stdlib.h>
#include <string.h>

// Streams of random numbers, with the number of the feed added.
enum { STREAM_SIZE = 1 << 16, STREAM_ORDER = 1 << 17, STREAM_PLACE = 3 << 16 };

// Quantum (J) of the sums over particles that come or go, which must not depend on the order: 2^59 of the
// energy unit are 256 times what all contacts of a bed hold at their deepest (classes.c).
static double quantum(const qn_world *w)
{
    return w->energy_unit * 0x1p-4;
}

static double gravity_energy(const qn_world *w, double mass, qn_vec3 x)
{
    double along = w->period > 0 ? 0 : w->gravity.z * x.z;
    return -mass * (w->gravity.x * x.x + w->gravity.y * x.y + along);
}

static bool leaves(const qn_outlet_def *o, qn_vec3 x, double radius)
{
    if (o->is_box)
        return x.x >= o->low.x && x.y >= o->low.y && x.z >= o->low.z && x.x <= o->high.x
               && x.y <= o->high.y && x.z <= o->high.z;
    bool screen = isfinite(o->aperture);
    if (screen && 2 * radius >= o->aperture) return false;
    qn_vec3 d = qn_sub(x, o->point);
    double past = qn_dot(d, o->normal), aside2 = qn_dot(d, d) - past * past;
    return past > (screen ? -radius : 0) && aside2 <= o->radius * o->radius;
}

// Kinetic energy and that in gravity of particle i at the present step.
static double energy_of(const qn_world *w, int i)
{
    const qn_class *c = &w->classes[w->place[i].klass];
    qn_vec3 v = qn_velocity_now(w, i), spin = qn_spin_now(w, i);
    return 0.5 * c->mass * qn_dot(v, v) + 0.5 * c->inertia * qn_dot(spin, spin)
           + gravity_energy(w, c->mass, qn_world_position(w, i));
}

qn_status qn_flow_look(qn_world *w)
{
    qn_flow *f = w->flow;
    int64_t energy = 0;
    f->gone_count = 0;
    if (f->outlet_count == 0 || w->step % f->outlet_stride != 0) return QN_OK;
    QN_TRY(QN_RESERVE(f->gone, f->gone_room, w->count));
    for (int i = 0; i < w->count; i++) {
        int klass = w->place[i].klass;
        f->gone[i] = false;
        if (w->classes[klass].inverse_mass <= 0) continue;
        for (int k = 0; k < f->outlet_count && !f->gone[i]; k++) {
            if (!leaves(&w->def.outlets[k], qn_world_position(w, i), w->classes[klass].radius))
                continue;
            f->gone[i] = true;
            f->gone_count++;
            f->taken[k * f->class_count + klass]++;
            energy += llrint(energy_of(w, i) / quantum(w));
        }
    }
    if (f->gone_count > 0) energy += qn_flow_stored(w, f->gone, quantum(w));
    f->energy[1] += (double)energy * quantum(w);
    return QN_OK;
}

// Class of the next sphere of a feed.
static int draw(const qn_world *w, int feed, int64_t number)
{
    const qn_group_def *g = &w->def.groups[w->def.feeds[feed].group];
    double u = qn_random(w->def.seed, STREAM_SIZE + (uint64_t)feed, (uint64_t)number), sum = 0;
    int s = 0;
    while (s + 1 < g->size_count && u >= (sum += g->fraction[s])) s++;
    return w->flow->feeds[feed].first_class + s;
}

// Whether the next sphere of a feed is due, by number or by half its mass.
static bool is_due(const qn_world *w, int feed, int klass)
{
    const qn_feed_def *def = &w->def.feeds[feed];
    const int64_t *fed = w->flow->fed + (int64_t)feed * w->class_count;
    double asked = qn_flow_asked(w, feed, qn_world_time(w));
    if (!(asked > 0)) return false;
    if (!def->by_mass) return (double)(qn_flow_count(w, fed) + 1) <= asked;
    return qn_flow_mass(w, fed) + 0.5 * w->classes[klass].mass <= asked;
}

// The space around a feed's sites, with the spheres in it that stay.
static qn_status occupy(const qn_world *w, const qn_feed *feed, double largest, qn_occupied *o)
{
    qn_vec3 low = feed->sites[0], high = low;
    double reach = 2 * largest + w->largest_radius;  // as displaced() leaves a site by `largest`
    for (int k = 1; k < feed->site_count; k++) {
        const qn_vec3 *s = &feed->sites[k];
        low = qn_v3(qn_min(low.x, s->x), qn_min(low.y, s->y), qn_min(low.z, s->z));
        high = qn_v3(qn_max(high.x, s->x), qn_max(high.y, s->y), qn_max(high.z, s->z));
    }
    low = qn_sub(low, qn_v3(reach, reach, reach)), high = qn_add(high, qn_v3(reach, reach, reach));
    if (w->period > 0) low.z = 0, high.z = w->period;
    QN_TRY(qn_occupied_create(o, low, high, w->period, qn_max(largest, w->largest_radius),
                              feed->site_count));
    for (int i = 0; i < w->count; i++) {
        if (w->flow->gone_count > 0 && w->flow->gone[i]) continue;
        qn_vec3 x = qn_world_position(w, i);
        bool near = x.x >= low.x && x.y >= low.y && x.x <= high.x && x.y <= high.y
                    && (w->period > 0 || (x.z >= low.z && x.z <= high.z));
        if (near) QN_TRY(qn_occupied_add(o, x, w->classes[w->place[i].klass].radius));
    }
    return QN_OK;
}

// The spheres found room for at this step, of all feeds.
typedef struct intake {
    qn_seedling *fresh;  // owned
    int64_t room;
    int count;
    int64_t energy;  // in quanta
} intake;

static qn_status take_in(qn_world *w, int number, qn_vec3 site, int klass, intake *in)
{
    const qn_feed_def *def = &w->def.feeds[number];
    const qn_group_def *g = &w->def.groups[def->group];
    const qn_class *c = &w->classes[klass];
    QN_TRY(QN_RESERVE(in->fresh, in->room, in->count + 1));
    in->fresh[in->count++] = (qn_seedling){site, def->velocity, g->spin, klass};
    double energy = 0.5 * c->mass * qn_dot(def->velocity, def->velocity)
                    + 0.5 * c->inertia * qn_dot(g->spin, g->spin)
                    + gravity_energy(w, c->mass, site);
    in->energy += llrint(energy / quantum(w));
    w->flow->fed[(int64_t)number * w->class_count + klass]++;
    return QN_OK;
}

// A coordinate mirrored at the ends of a range, so that it stays evenly spread within.
static double mirrored(double x, double low, double high)
{
    x = x < low ? 2 * low - x : x > high ? 2 * high - x : x;
    return qn_max(low, qn_min(x, high));
}

// A site moved by an offset, its sphere with its padding (radius in m) still within the feed's region.
static qn_vec3 displaced(const qn_feed_def *def, double radius, qn_vec3 site, qn_vec3 offset)
{
    qn_vec3 x = qn_add(site, offset), low = def->low, high = def->high;
    if (!def->is_disc)
        return qn_v3(
            mirrored(x.x, qn_min(low.x + radius, site.x), qn_max(high.x - radius, site.x)),
            mirrored(x.y, qn_min(low.y + radius, site.y), qn_max(high.y - radius, site.y)),
            mirrored(x.z, qn_min(low.z + radius, site.z), qn_max(high.z - radius, site.z)));
    qn_vec3 aside = qn_sub(x, def->centre);
    aside = qn_madd(aside, -qn_dot(aside, def->normal), def->normal);
    double far = qn_norm(aside), most = qn_max(0, def->radius - radius);
    return qn_madd(def->centre, far > most ? most / far : 1, aside);
}

// Finds a free place for a sphere at a site: anywhere in the site's cell, so that spheres do not come in
// columns, or, where others are in the way, within the padding. False where there is none.
static bool find_place(const qn_world *w, int number, const qn_occupied *o, const qn_pose *pose,
                       uint64_t draw, double radius, qn_vec3 *site)
{
    const qn_feed_def *def = &w->def.feeds[number];
    double padding = w->def.groups[def->group].padding, cell = w->flow->feeds[number].radius, u[3];
    uint64_t stream = STREAM_PLACE + (uint64_t)number;
    for (uint64_t i = 0; i < 3; i++) u[i] = 2 * qn_random(w->def.seed, stream, 3 * draw + i) - 1;
    // Within the padding p r, two neighbours may each move by p r/2; u is up to sqrt(3) long.
    const double reach[] = {cell, 0.25 * cell * padding / (1 + padding)};
    for (int k = 0; k < 2; k++) {
        qn_vec3 offset = qn_scale(reach[k], qn_v3(u[0], u[1], u[2]));
        qn_vec3 x = displaced(def, cell, *site, offset);
        if (w->period > 0) x.z -= floor(x.z / w->period) * w->period;
        if (!qn_occupied_is_free(o, x, radius * (1 + padding))) continue;
        if (!(qn_walls_clearance(&w->walls, pose, x) >= radius)) continue;
        *site = x;
        return true;
    }
    return false;
}

// Sites in a random order, each tried for the sphere that is next; a sphere without room waits, and those
// behind it too.
static qn_status fill(qn_world *w, int number, qn_occupied *o, intake *in)
{
    const qn_feed *feed = &w->flow->feeds[number];
    const int64_t *fed = w->flow->fed + (int64_t)number * w->class_count;
    qn_pose pose = qn_walls_pose(&w->walls, qn_world_time(w));
    uint64_t stream = STREAM_ORDER + (uint64_t)number;
    uint64_t turn = qn_random_bits(w->def.seed, stream, (uint64_t)w->step);
    int first = (int)(turn % (uint64_t)feed->site_count);
    for (int k = 0; k < feed->site_count; k++) {
        qn_vec3 site = feed->sites[(first + k) % feed->site_count];
        int klass = draw(w, number, qn_flow_count(w, fed));
        double radius = w->classes[klass].radius;
        if (!is_due(w, number, klass)) break;
        if (!find_place(w, number, o, &pose, turn + (uint64_t)k, radius, &site)) continue;
        QN_TRY(qn_occupied_add(o, site, radius));
        QN_TRY(take_in(w, number, site, klass, in));
    }
    return QN_OK;
}

static qn_status feed_one(qn_world *w, int number, intake *in)
{
    const qn_feed *feed = &w->flow->feeds[number];
    const int64_t *fed = w->flow->fed + (int64_t)number * w->class_count;
    if (w->step % feed->stride != 0) return QN_OK;
    if (!is_due(w, number, draw(w, number, qn_flow_count(w, fed)))) return QN_OK;
    qn_occupied o;
    qn_status status = occupy(w, feed, feed->radius, &o);
    for (int k = 0; k < in->count && status == QN_OK; k++)
        status = qn_occupied_add(&o, in->fresh[k].position, w->classes[in->fresh[k].klass].radius);
    if (status == QN_OK) status = fill(w, number, &o, in);
    qn_occupied_free(&o);
    return status;
}

qn_status qn_flow_act(qn_world *w)
{
    qn_flow *f = w->flow;
    intake in = {0};
    qn_status status = QN_OK;
    for (int k = 0; k < f->feed_count && status == QN_OK; k++) status = feed_one(w, k, &in);
    bool leaving = f->gone_count > 0;
    if (status == QN_OK && (leaving || in.count > 0))
        status = qn_population_change(w, leaving ? f->gone : NULL, in.fresh, in.count, f->next_id);
    f->next_id += in.count;
    f->energy[0] += (double)in.energy * quantum(w);
    f->gone_count = 0;
    free(in.fresh);
    return status;
}
