// SPDX-License-Identifier: Apache-2.0
#include "world/timestep.h"
#include "world/classes.h"

double qn_rayleigh_time(const qn_material_def *material, double radius)
{
    double shear = material->youngs_modulus / (2 * (1 + material->poisson_ratio));
    return QN_PI * radius * sqrt(material->density / shear)
           / (0.1631 * material->poisson_ratio + 0.8766);
}

double qn_hertz_time(double k, double effective_mass, double speed, double *depth)
{
    double d = pow(5 * effective_mass * speed * speed / (4 * k), 0.4);
    if (depth) *depth = d;
    return 2.94328 * d / speed;
}

// Fastest impact to expect: in a drum a ball at the shell's speed falling through the diameter;
// elsewhere the fastest ball falling through the height the scene spans.
static double impact_speed(const qn_def *def)
{
    double g = qn_norm(def->gravity), fastest = 0, drop = 0;
    if (def->drum.present) {
        for (int i = 0; i < def->drum.leg_count; i++)
            fastest =
                qn_max(fastest, qn_max(fabs(def->drum.legs[i].from), fabs(def->drum.legs[i].to)));
        fastest *= def->drum.diameter / 2;
        drop = def->drum.diameter;
    }
    double low = INFINITY, high = -INFINITY;  // m2/s2   of the potential g.x
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *group = &def->groups[k];
        fastest = qn_max(fastest, qn_norm(group->velocity));
        for (int i = 0; i < group->list_count; i++) {
            const double *x = &group->list_position[3 * i];
            double potential = qn_dot(def->gravity, qn_v3(x[0], x[1], x[2]));
            low = qn_min(low, potential), high = qn_max(high, potential);
            if (group->list_velocity) {
                const double *v = &group->list_velocity[3 * i];
                fastest = qn_max(fastest, qn_norm(qn_v3(v[0], v[1], v[2])));
            }
        }
    }
    for (int i = 0; i < def->plane_count; i++) {
        double potential = qn_dot(def->gravity, def->planes[i].point);
        low = qn_min(low, potential), high = qn_max(high, potential);
    }
    if (g > 0 && high > low) drop = qn_max(drop, (high - low) / g);
    double speed = sqrt(fastest * fastest + 2 * g * drop);
    return speed > 0 ? speed : 1e-3;
}

// Shortens `t` to the contact of two sides under their law.
static void take_pair(qn_timestep *t, const qn_contact_def *contact, const qn_sides *sides)
{
    double mass = qn_effective_mass(sides), time, depth;
    if (isinf(mass)) return;
    if (contact->law == QN_LAW_LINEAR) {
        double zeta = qn_sides_damping_ratio(sides), e = sides->restitution;
        time = sqrt(mass / sides->stiffness) * (zeta > 1e-6 ? -log(e) / zeta : QN_PI);
        depth = t->impact_speed * sqrt(mass / sides->stiffness);
    } else {
        qn_pair pair = qn_law_pair(contact->law, sides);
        double k = pair.normal_stiffness * pow(pair.depth_scale, 1.5);
        time = qn_hertz_time(k, mass, t->impact_speed, &depth);
    }
    double smaller = qn_min(fabs(sides->radius[0]), fabs(sides->radius[1]));
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
    qn_timestep t = {impact_speed(def), INFINITY, INFINITY, 0, 0};
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
            take_pair(&t, contact, &sides);
        }
        for (int m = 0; m < def->material_count; m++) {
            const qn_contact_def *contact = qn_def_contact(def, c->material, m);
            qn_surface surface = {m, INFINITY};
            qn_sides sides;
            if (!contact || !qn_def_is_wall(def, m)) continue;
            sides = qn_sides_of_wall(def, contact, c, &surface, 1);
            take_pair(&t, contact, &sides);
        }
    }
    t.suggested =
        three_digits(qn_min(def->rayleigh_fraction * t.rayleigh, t.contact / QN_STEPS_PER_CONTACT));
    return t;
}
