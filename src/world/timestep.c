// SPDX-License-Identifier: Apache-2.0
#include "world/timestep.h"
#include "world/classes.h"

double qn_rayleigh_time(const qn_material_def *material, double radius)
{
    double shear = material->youngs_modulus / (2 * (1 + material->poisson_ratio));
    return QN_PI * radius * sqrt(material->density / shear)
           / (0.1631 * material->poisson_ratio + 0.8766);
}

double qn_impact_time(double k, double power, double effective_mass, double speed, double *depth)
{
    double q = power + 1;
    double d = pow(q * effective_mass * speed * speed / (2 * k), 1 / q);
    if (depth) *depth = d;
    return 2 * sqrt(QN_PI) * tgamma(1 + 1 / q) / tgamma(0.5 + 1 / q) * d / speed;
}

typedef struct speeds {
    double particle, wall;  // m/s  the fastest to expect
    double partner;         // m/s  of what a fast particle meets head-on
} speeds;

typedef struct span {
    double low, high;
} span;

static void widen(span *s, double x)
{
    s->low = qn_min(s->low, x);
    s->high = qn_max(s->high, x);
}

// Speed (m/s) of the fastest point of drum and turning meshes; the height (m) they let things fall.
static double turning_speed(const qn_def *def, double *drop)
{
    double fastest = 0, radius = def->drum.diameter / 2;
    if (!def->drum.present) return 0;
    for (int i = 0; i < def->mesh_count; i++) {
        const qn_mesh_def *mesh = &def->meshes[i];
        for (int v = 0; mesh->drive.kind == QN_DRIVE_DRUM && v < mesh->vertex_count; v++)
            radius = qn_max(radius, hypot(mesh->vertices[3 * v], mesh->vertices[3 * v + 1]));
    }
    for (int i = 0; i < def->drum.leg_count; i++)
        fastest = qn_max(fastest,
                         qn_max(fabs(def->drum.legs[i].from), fabs(def->drum.legs[i].to)) * radius);
    *drop = 2 * radius;
    return fastest;
}

// Speed (m/s) of the fastest of the points that planes and meshes with a motion of their own are given by.
// How far (m) from a point the scene's drum and listed particles reach: a plane has no end of its own.
static double extent(const qn_def *def, qn_vec3 from)
{
    double far = def->drum.present ? def->drum.diameter / 2 + qn_norm(from) : 0;
    for (int k = 0; k < def->group_count; k++)
        for (int i = 0; i < def->groups[k].list_count; i++) {
            const double *x = &def->groups[k].list_position[3 * i];
            far = qn_max(far, qn_norm(qn_sub(qn_v3(x[0], x[1], x[2]), from)));
        }
    return far;
}

static double driven_speed(const qn_def *def)
{
    double fastest = 0;
    for (int i = 0; i < def->plane_count; i++) {
        const qn_plane_def *p = &def->planes[i];
        double far =
            qn_max(qn_norm(qn_sub(p->point, p->drive.through)), extent(def, p->drive.through));
        fastest = qn_max(fastest, qn_drive_fastest(&p->drive, far));
    }
    for (int i = 0; i < def->mesh_count; i++) {
        const qn_mesh_def *m = &def->meshes[i];
        double far = 0;
        for (int v = 0; v < m->vertex_count; v++) {
            const double *x = &m->vertices[3 * v];
            far = qn_max(far, qn_norm(qn_sub(qn_v3(x[0], x[1], x[2]), m->drive.through)));
        }
        fastest = qn_max(fastest, qn_drive_fastest(&m->drive, far));
    }
    return fastest;
}

// Height (m) between the highest and the lowest thing the scene places, along gravity.
static double height(const qn_def *def)
{
    double g = qn_norm(def->gravity);
    span s = {INFINITY, -INFINITY};  // m2/s2   of the potential g.x
    for (int k = 0; k < def->group_count; k++)
        for (int i = 0; i < def->groups[k].list_count; i++) {
            const double *x = &def->groups[k].list_position[3 * i];
            widen(&s, qn_dot(def->gravity, qn_v3(x[0], x[1], x[2])));
        }
    for (int i = 0; i < def->plane_count; i++)
        widen(&s, qn_dot(def->gravity, def->planes[i].point));
    for (int i = 0; i < def->mesh_count; i++)
        for (int v = 0; v < def->meshes[i].vertex_count; v++) {
            const double *x = &def->meshes[i].vertices[3 * v];
            widen(&s, qn_dot(def->gravity, qn_v3(x[0], x[1], x[2])));
        }
    return g > 0 && s.high > s.low ? (s.high - s.low) / g : 0;
}

static double given_speed(const qn_def *def)
{
    double fastest = 0;
    for (int k = 0; k < def->feed_count; k++)
        fastest = qn_max(fastest, qn_norm(def->feeds[k].velocity));
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *group = &def->groups[k];
        if (!group->list_velocity) fastest = qn_max(fastest, qn_norm(group->velocity));
        for (int i = 0; group->list_velocity && i < group->list_count; i++) {
            const double *v = &group->list_velocity[3 * i];
            fastest = qn_max(fastest, qn_norm(qn_v3(v[0], v[1], v[2])));
        }
    }
    return fastest;
}

// The fastest particle moves like the shell or as the scene says, and has fallen as far as it can. In a
// drum it meets what moves with the shell; elsewhere another one, thrown back, that is as fast.
static speeds speeds_of(const qn_def *def)
{
    double drop = 0, turning = turning_speed(def, &drop);
    turning = qn_max(turning, driven_speed(def));
    double begin = qn_max(turning, given_speed(def));
    drop = qn_max(drop, height(def));
    double end = sqrt(begin * begin + 2 * qn_norm(def->gravity) * drop);
    if (!(end > 0)) end = 1e-3;
    return (speeds){end, turning, def->drum.present ? begin : end};
}

// The time with a mass (kg) other than the one the coefficients are made of.
static double contact_time(const qn_contact_def *contact, const qn_sides *sides, double mass,
                           double speed, double *depth)
{
    qn_normal_model normal = contact->law.normal;
    qn_pair pair = qn_law_pair(contact->law, sides);
    double k = qn_normal_at(normal, &pair, 1).elastic;
    return qn_impact_time(k, qn_normal_power(normal), mass, speed, depth);
}

double qn_contact_time(const qn_contact_def *contact, const qn_sides *sides, double speed,
                       double *depth)
{
    return contact_time(contact, sides, qn_effective_mass(sides), speed, depth);
}

// Shortens `t` to the contact of two sides that meet at `speed` under their law; `light` is the least mass
// (kg) that is felt of each: of a clump hit off its centre, less than its own.
static void take_pair(qn_timestep *t, const qn_contact_def *contact, const qn_sides *sides,
                      const double light[2], double speed)
{
    qn_sides lightest = *sides;
    double depth, zeta = qn_sides_damping_ratio(sides);
    if (isinf(qn_effective_mass(sides))) return;
    lightest.mass[0] = light[0], lightest.mass[1] = light[1];
    double time = contact_time(contact, sides, qn_effective_mass(&lightest), speed, &depth);
    double heavy;
    qn_contact_time(contact, sides, speed, &heavy);
    depth = qn_max(depth, heavy);
    if (contact->law.damping == QN_DAMPING_VISCOUS && zeta > 1e-6)
        time *= -log(sides->restitution) / zeta / QN_PI;
    double smaller = qn_min(fabs(sides->radius[0]), fabs(sides->radius[1]));
    t->impact_speed = qn_max(t->impact_speed, speed);
    t->contact = qn_min(t->contact, time);
    t->largest_overlap = qn_max(t->largest_overlap, depth / smaller);
}

// Rounds down to three digits, so that the step does not hang on the last bit of the C library's pow.
static double three_digits(double x)
{
    double scale = 1;
    while (x * scale < 100 && scale < 1e22) scale *= 10;
    return isfinite(x) ? floor(x * scale) / scale : x;
}

qn_timestep qn_timestep_of(const qn_def *def, const qn_class *classes, int class_count)
{
    speeds v = speeds_of(def);
    qn_timestep t = {0, INFINITY, INFINITY, 0, 0};
    for (int a = 0; a < class_count; a++) {
        const qn_class *c = &classes[a];
        if (c->inverse_mass > 0)
            t.rayleigh =
                qn_min(t.rayleigh, qn_rayleigh_time(&def->materials[c->material], c->radius));
        for (int b = 0; b < class_count; b++) {
            const qn_contact_def *contact = qn_def_contact(def, c->material, classes[b].material);
            qn_sides sides;
            if (!contact || !qn_classes_can_meet(def, c, &classes[b])) continue;
            sides = qn_sides_of_classes(def, contact, c, &classes[b], 1);
            bool both = c->inverse_mass > 0 && classes[b].inverse_mass > 0;
            const double light[2] = {c->least_mass, classes[b].least_mass};
            double other = both ? v.partner : c->turning || classes[b].turning ? v.wall : 0;
            take_pair(&t, contact, &sides, light, v.particle + other);
        }
        for (int m = 0; m < def->material_count; m++) {
            const qn_contact_def *contact = qn_def_contact(def, c->material, m);
            qn_surface surface = {m, INFINITY};
            qn_sides sides;
            if (!contact || !qn_def_is_wall(def, m)) continue;
            sides = qn_sides_of_wall(def, contact, c, &surface, 1);
            const double light[2] = {c->least_mass, INFINITY};
            take_pair(&t, contact, &sides, light, v.particle + v.wall);
        }
    }
    if (!(t.impact_speed > 0)) t.impact_speed = v.particle;  // nothing meets anything
    t.suggested =
        three_digits(qn_min(def->rayleigh_fraction * t.rayleigh, t.contact / QN_STEPS_PER_CONTACT));
    return t;
}
