// SPDX-License-Identifier: Apache-2.0
#include "world/flow.h"
#include "world/lattice.h"
#include "world/timestep.h"

#include <stdlib.h>

enum { SITES_MAX = 1000000, MOMENTS = 16 };  // of one feed

#define QUARTER 0.25  // 1   of the smallest radius: what the fastest may move between two looks

static qn_status add_site(qn_feed *feed, int64_t *room, qn_vec3 site)
{
    QN_TRY(QN_RESERVE(feed->sites, *room, feed->site_count + 1));
    feed->sites[feed->site_count++] = site;
    return QN_OK;
}

static qn_status too_large(const qn_feed_def *def)
{
    return qn_fail(QN_INPUT,
                   "feeds.%s: its region has more than %d places for spheres; make it smaller",
                   def->name, SITES_MAX);
}

static qn_status fill_box(qn_feed *feed, const qn_feed_def *def, double radius)
{
    int64_t room = 0;
    qn_lattice lattice = qn_lattice_lay(def->low, def->high, false, true, radius);
    int64_t sites = lattice.per_row > 0 ? qn_lattice_below(&lattice, def->high.y) : 0;
    if (sites > SITES_MAX) return too_large(def);
    for (int64_t k = 0; k < sites; k++) {
        qn_vec3 site;
        if (qn_lattice_site(&lattice, k, &site)) QN_TRY(add_site(feed, &room, site));
    }
    return QN_OK;
}

// A square lattice in the plane of the disc, with a site at its centre.
static qn_status fill_disc(qn_feed *feed, const qn_feed_def *def, double radius)
{
    int64_t room = 0;
    qn_vec3 n = def->normal;
    qn_vec3 aside = fabs(n.x) < 0.6 ? qn_v3(1, 0, 0) : qn_v3(0, 1, 0);
    qn_vec3 u = qn_cross(n, aside);
    u = qn_scale(1 / qn_norm(u), u);
    qn_vec3 v = qn_cross(n, u);
    double most = def->radius - radius;
    if (most > 0.4 * radius * sqrt(SITES_MAX)) return too_large(def);
    int reach = most >= 0 ? (int)(most / (2 * radius)) : -1;
    for (int i = -reach; i <= reach; i++)
        for (int j = -reach; j <= reach; j++) {
            double x = 2 * radius * i, y = 2 * radius * j;
            if (x * x + y * y > most * most) continue;
            QN_TRY(add_site(feed, &room, qn_madd(qn_madd(def->centre, x, u), y, v)));
        }
    return QN_OK;
}

// Steps in which a sphere of the feed has moved a quarter of its own size: at its speed, or falling.
static int64_t occasions(const qn_world *w, const qn_feed_def *def, double diameter)
{
    double speed = qn_norm(def->velocity), g = qn_norm(w->gravity);
    double time = 1e6 * w->dt;
    if (speed > 0) time = qn_min(time, 0.25 * diameter / speed);
    if (g > 0) time = qn_min(time, sqrt(0.5 * diameter / g));
    double steps = floor(time / w->dt);
    return steps < 1 ? 1 : (int64_t)steps;
}

static qn_status feed_create(const qn_world *w, const qn_feed_def *def, qn_feed *feed)
{
    const qn_group_def *g = &w->def.groups[def->group];
    double largest = 0;
    for (int s = 0; s < g->size_count; s++) largest = qn_max(largest, g->diameter[s]);
    double radius = largest / 2 * (1 + g->padding);
    feed->radius = radius;
    for (int k = 0; k < def->group; k++) feed->first_class += w->def.groups[k].size_count;
    feed->stride = occasions(w, def, largest);
    QN_TRY(def->is_disc ? fill_disc(feed, def, radius) : fill_box(feed, def, radius));
    if (feed->site_count > 0) return QN_OK;
    return qn_fail(QN_INPUT,
                   "feeds.%s: its region has no room for a sphere of %g m with its padding",
                   def->name, largest);
}

static double end_of_run(const qn_world *w)
{
    if (w->def.end.unit == QN_REVOLUTIONS)
        return qn_drum_time(&w->def.drum, 2 * QN_PI * w->def.end.value);
    return w->def.end.value * (w->def.end.unit == QN_STEPS ? w->dt : 1);
}

void qn_flow_expected(const qn_world *w, int feed, double *spheres, double *mass)
{
    const qn_feed_def *def = &w->def.feeds[feed];
    const qn_group_def *g = &w->def.groups[def->group];
    double each = 0, asked = qn_flow_asked(w, feed, end_of_run(w));
    for (int s = 0; s < g->size_count; s++)
        each += g->fraction[s] * qn_ball_volume(g->diameter[s] / 2)
                * w->def.materials[g->material].density;
    *spheres = def->by_mass ? asked / each : asked;
    *mass = def->by_mass ? asked : asked * each;
}

// Whether the walls of a moment leave a feed room. A sphere may lie sqrt(3) cells from its site, and the
// clearance changes by no more than that on the way.
static bool has_room(const qn_world *w, const qn_feed *feed, double smallest, double t)
{
    qn_pose pose = qn_walls_pose(&w->walls, t);
    double least = smallest - sqrt(3.0) * feed->radius;
    for (int k = 0; k < feed->site_count; k++) {
        qn_vec3 site = feed->sites[k];
        if (w->period > 0) site.z -= floor(site.z / w->period) * w->period;
        if (qn_walls_clearance(&w->walls, &pose, site) >= least) return true;
    }
    return false;
}

// Walls that move are looked at now and then while the feed is open.
static qn_status check_room(const qn_world *w, int number)
{
    const qn_feed_def *def = &w->def.feeds[number];
    const qn_group_def *g = &w->def.groups[def->group];
    int moments = w->walls.body_count > 1 ? MOMENTS : 1;
    double open = qn_min(def->stop, end_of_run(w)) - def->start, smallest = g->diameter[0] / 2;
    for (int s = 1; s < g->size_count; s++) smallest = qn_min(smallest, g->diameter[s] / 2);
    if (!isfinite(open) || open < 0) open = 0;
    for (int m = 0; m < moments; m++)
        if (has_room(w, &w->flow->feeds[number], smallest, def->start + open * m / moments))
            return QN_OK;
    return qn_fail(QN_INPUT,
                   "feeds.%s: its region has no room within the walls for a sphere of %g m; they "
                   "are in its way, or it lies outside of them",
                   def->name, 2 * smallest);
}

// Clumps stay: a body would have to come or go with all its spheres.
static qn_status refuse_clumps(const qn_world *w)
{
    for (int k = 0; k < w->def.feed_count; k++)
        if (w->def.groups[w->def.feeds[k].group].shape)
            return qn_fail(QN_INPUT, "feeds.%s: clumps cannot be fed, only spheres",
                           w->def.feeds[k].name);
    for (int g = 0; g < w->def.group_count && w->def.outlet_count > 0; g++)
        if (w->def.groups[g].shape && !w->def.groups[g].fixed)
            return qn_fail(QN_INPUT,
                           "outlets.%s: the clumps of particles.%s cannot leave, only spheres can",
                           w->def.outlets[0].name, w->def.groups[g].name);
    return QN_OK;
}

qn_status qn_flow_create(qn_world *w)
{
    qn_flow *f;
    int classes = w->class_count;
    if (w->def.feed_count + w->def.outlet_count == 0) return QN_OK;
    QN_TRY(refuse_clumps(w));
    QN_TRY(QN_ALLOCATE(f, 1));
    w->flow = f;
    f->class_count = classes;
    f->outlet_count = w->def.outlet_count;
    f->next_id = w->count + 1;
    QN_TRY(QN_ALLOCATE(f->feeds, w->def.feed_count));
    QN_TRY(QN_ALLOCATE(f->fed, w->def.feed_count * classes));
    QN_TRY(QN_ALLOCATE(f->taken, w->def.outlet_count * classes));
    double most = w->count;
    for (int k = 0; k < w->def.feed_count; k++) {
        f->feed_count++;
        QN_TRY(feed_create(w, &w->def.feeds[k], &f->feeds[k]));
        QN_TRY(check_room(w, k));
        double spheres, mass;
        qn_flow_expected(w, k, &spheres, &mass);
        most += qn_min(1e9, spheres);
    }
    f->most = (int64_t)most;
    double speed = qn_timestep_of(&w->def, w->classes, classes).impact_speed;
    double steps = floor(QUARTER * w->smallest_radius / (speed * w->dt));
    f->outlet_stride = steps < 1 ? 1 : (int64_t)qn_min(steps, 1e6);
    return QN_OK;
}

void qn_flow_destroy(qn_flow *f)
{
    if (!f) return;
    for (int k = 0; k < f->feed_count; k++) free(f->feeds[k].sites);
    free(f->feeds), free(f->gone), free(f->fed), free(f->taken);
    free(f);
}

double qn_flow_energy_in(const qn_world *w)
{
    return w->flow ? w->flow->energy[0] : 0;
}

double qn_flow_energy_out(const qn_world *w)
{
    return w->flow ? w->flow->energy[1] : 0;
}

int64_t qn_flow_count(const qn_world *w, const int64_t *by_class)
{
    int64_t sum = 0;
    for (int c = 0; c < w->class_count; c++) sum += by_class[c];
    return sum;
}

double qn_flow_mass(const qn_world *w, const int64_t *by_class)
{
    double sum = 0;
    for (int c = 0; c < w->class_count; c++) sum += (double)by_class[c] * w->classes[c].mass;
    return sum;
}

double qn_flow_total_count(const qn_world *w, int which)
{
    const qn_flow *f = w->flow;
    double sum = 0;
    for (int k = 0; f && k < (which ? f->outlet_count : f->feed_count); k++)
        sum += (double)qn_flow_count(w, (which ? f->taken : f->fed) + k * f->class_count);
    return sum;
}

double qn_flow_total_mass(const qn_world *w, int which)
{
    const qn_flow *f = w->flow;
    double sum = 0;
    for (int k = 0; f && k < (which ? f->outlet_count : f->feed_count); k++)
        sum += qn_flow_mass(w, (which ? f->taken : f->fed) + k * f->class_count);
    return sum;
}

double qn_flow_asked(const qn_world *w, int feed, double t)
{
    const qn_feed_def *def = &w->def.feeds[feed];
    return def->rate * qn_max(0, qn_min(t, def->stop) - def->start);
}

bool qn_flow_is_short(const qn_world *w, int feed, double *given, double *asked)
{
    const qn_feed_def *def = &w->def.feeds[feed];
    const qn_group_def *g = &w->def.groups[def->group];
    const qn_feed *f = &w->flow->feeds[feed];
    const int64_t *fed = w->flow->fed + feed * w->flow->class_count;
    double sphere = def->by_mass ? 0 : 1;
    for (int s = 0; s < g->size_count && def->by_mass; s++)
        sphere = qn_max(sphere, w->classes[f->first_class + s].mass);
    *asked = qn_flow_asked(w, feed, qn_world_time(w));
    *given = def->by_mass ? qn_flow_mass(w, fed) : (double)qn_flow_count(w, fed);
    return *asked - *given > sphere + def->rate * (double)f->stride * w->dt;
}

int64_t qn_flow_most(const qn_world *w)
{
    return w->flow && w->flow->most > w->count ? w->flow->most : w->count;
}

int qn_flow_columns(qn_flow *f, qn_column c[QN_FLOW_COLUMNS])
{
    c[0] = (qn_column){"next_id", "1", "of the next particle fed", QN_INT64, 1, 1, &f->next_id};
    c[1] = (qn_column){
        "fed",         "1",   "particles given, by feed and class", QN_INT64, f->class_count,
        f->feed_count, f->fed};
    c[2] = (qn_column){
        "taken",         "1",     "particles taken, by outlet and class", QN_INT64, f->class_count,
        f->outlet_count, f->taken};
    c[3] = (qn_column){"energy", "J", "brought in by feeds, taken out by outlets", QN_DOUBLE, 1, 2,
                       f->energy};
    return QN_FLOW_COLUMNS;
}
