// SPDX-License-Identifier: Apache-2.0
#include "world/classes.h"

#include <stdlib.h>
#include <string.h>

int qn_radii_of(const qn_def *def, const qn_group_def *group, int *which)
{
    const qn_shape *s = &def->shapes[group->shape - 1];
    int first[QN_SPHERES_MAX], count = 0;
    for (int i = 0; i < s->count; i++) {
        int d = 0;
        while (d < count && s->radius[first[d]] != s->radius[i]) d++;
        if (d == count) first[count++] = i;
        if (which) which[i] = d;
    }
    return count;
}

// Makes the class of a ball of radius r (m) that of the first sphere of a clump of equal volume.
static void shape_class(qn_class *c, const qn_shape *s, double r, int grain)
{
    double mean = (s->moment.x + s->moment.y + s->moment.z) / 3;
    double least = qn_min(s->moment.x, qn_min(s->moment.y, s->moment.z));
    c->grain = grain;
    c->radius = r * s->radius[0];
    c->bound = r * s->bound;
    c->inertia = mean * c->mass * r * r;
    c->volume *= s->overlap * s->radius[0] * s->radius[0] * s->radius[0];
    c->least_mass = c->mass / (1 + s->arm * s->arm / least);  // hit with the longest lever
}

// The classes of clumps' spheres that are not as large as the first, from `c` on.
static void other_radii(const qn_def *def, const qn_class *firsts, qn_class *c)
{
    int which[QN_SPHERES_MAX];
    const qn_class *first = firsts;
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *group = &def->groups[k];
        int radii = group->shape ? qn_radii_of(def, group, which) : 1;
        for (int size = 0; size < group->size_count; size++, first++)
            for (int d = 1; d < radii; d++, c++) {
                const qn_shape *s = &def->shapes[group->shape - 1];
                int i = 0;
                while (which[i] != d) i++;
                double ratio = s->radius[i] / s->radius[0];
                *c = *first;
                c->radius = group->diameter[size] / 2 * s->radius[i];
                c->volume = first->volume * ratio * ratio * ratio;
            }
    }
}

qn_status qn_classes_build(const qn_def *def, qn_class **classes, int *count)
{
    int total = 0, grain = 0;
    for (int k = 0; k < def->group_count; k++) {
        const qn_group_def *group = &def->groups[k];
        total += group->size_count * (group->shape ? qn_radii_of(def, group, NULL) : 1);
    }
    QN_TRY(QN_ALLOCATE(*classes, total));
    *count = total;
    qn_class *c = *classes;
    for (int k = 0; k < def->group_count; k++)
        for (int s = 0; s < def->groups[k].size_count; s++, c++) {
            const qn_group_def *group = &def->groups[k];
            double r = group->diameter[s] / 2;
            c->group = k, c->size = s, c->material = group->material;
            c->grain = -1;
            c->radius = c->bound = r;
            c->mass = 4.0 / 3 * QN_PI * r * r * r * def->materials[group->material].density;
            c->inertia = 0.4 * c->mass * r * r;
            c->volume = 4.0 / 3.0 * QN_PI * r * r * r;
            c->least_mass = c->mass;
            if (group->shape) shape_class(c, &def->shapes[group->shape - 1], r, grain++);
            c->turning = group->turning;
            bool held = group->fixed || group->turning;
            c->inverse_mass = held ? 0 : 1 / c->mass;
            c->inverse_inertia = held ? 0 : 1 / c->inertia;
        }
    other_radii(def, *classes, c);
    return QN_OK;
}

// What both kinds of contact share.
static qn_sides sides_begin(const qn_def *def, const qn_contact_def *contact, const qn_class *a,
                            int other_material, double dt)
{
    const qn_material_def *m[2] = {&def->materials[a->material], &def->materials[other_material]};
    qn_sides s = {.clip = contact->clip,
                  .dt = dt,
#define C(name, unit, used, with) .name = contact->name,
                  QN_CONTACT_NUMBERS(C)
#undef C
    };
    for (int i = 0; i < 2; i++) {
        s.young[i] = m[i]->youngs_modulus;
        s.poisson[i] = m[i]->poisson_ratio;
    }
    s.radius[0] = a->radius, s.mass[0] = a->mass, s.fixed[0] = a->inverse_mass <= 0;
    return s;
}

qn_sides qn_sides_of_classes(const qn_def *def, const qn_contact_def *contact, const qn_class *a,
                             const qn_class *b, double dt)
{
    qn_sides s = sides_begin(def, contact, a, b->material, dt);
    s.radius[1] = b->radius, s.mass[1] = b->mass, s.fixed[1] = b->inverse_mass <= 0;
    return s;
}

qn_sides qn_sides_of_wall(const qn_def *def, const qn_contact_def *contact, const qn_class *a,
                          const qn_surface *surface, double dt)
{
    qn_sides s = sides_begin(def, contact, a, surface->material, dt);
    s.wall = true;
    s.radius[1] = surface->radius, s.mass[1] = INFINITY, s.fixed[1] = true;
    return s;
}

bool qn_def_is_wall(const qn_def *def, int material)
{
    const qn_drum_def *drum = &def->drum;
    bool found = drum->present
                 && (drum->material == material
                     || (drum->ends != QN_ENDS_PERIODIC && drum->end_material == material));
    for (int i = 0; i < def->plane_count; i++) found |= def->planes[i].material == material;
    for (int i = 0; i < def->mesh_count; i++) found |= def->meshes[i].material == material;
    return found;
}

static qn_status no_law(const qn_def *def, int a, int b)
{
    return qn_fail(QN_INPUT,
                   "contacts: no law for %s against %s, which can touch; add a line %s-%s",
                   def->materials[a].name, def->materials[b].name, def->materials[a].name,
                   def->materials[b].name);
}

bool qn_classes_can_meet(const qn_def *def, const qn_class *a, const qn_class *b)
{
    const qn_group_def *group = &def->groups[a->group];
    bool alone = a->group == b->group && group->packing == QN_PACK_LIST && group->list_count < 2;
    return !alone && (a->inverse_mass > 0 || b->inverse_mass > 0);
}

static qn_status pairs_of_classes(qn_world *w)
{
    int n = w->class_count;
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++) {
            const qn_class *ca = &w->classes[a], *cb = &w->classes[b];
            const qn_contact_def *contact = qn_def_contact(&w->def, ca->material, cb->material);
            w->reaches[a * n + b] =
                (qn_reach){ca->radius + cb->radius, ca->radius, cb->radius, 0.5, 0.5};
            if (!qn_classes_can_meet(&w->def, ca, cb)) continue;
            if (!contact) return no_law(&w->def, ca->material, cb->material);
            qn_sides sides = qn_sides_of_classes(&w->def, contact, ca, cb, w->dt);
            w->laws[a * n + b] = contact->law;
            w->rolls |= qn_law_remembers_rolling(contact->law);
            w->pairs[a * n + b] = qn_law_pair(contact->law, &sides);
        }
    return QN_OK;
}

static qn_status pairs_of_walls(qn_world *w)
{
    int n = w->class_count;
    for (int k = 0; k < w->surface_count; k++)
        for (int a = 0; a < n; a++) {
            const qn_surface *surface = &w->walls.surfaces[k];
            const qn_class *ca = &w->classes[a];
            const qn_contact_def *contact =
                qn_def_contact(&w->def, ca->material, surface->material);
            if (ca->inverse_mass <= 0) continue;  // held: never tried against walls
            if (!contact) return no_law(&w->def, ca->material, surface->material);
            qn_sides sides = qn_sides_of_wall(&w->def, contact, ca, surface, w->dt);
            w->wall_laws[k * n + a] = contact->law;
            w->rolls |= qn_law_remembers_rolling(contact->law);
            w->wall_pairs[k * n + a] = qn_law_pair(contact->law, &sides);
        }
    return QN_OK;
}

qn_status qn_pairs_build(qn_world *w)
{
    int pairs = w->class_count * w->class_count, touches = w->surface_count * w->class_count;
    QN_TRY(QN_ALLOCATE(w->laws, pairs));
    QN_TRY(QN_ALLOCATE(w->pairs, pairs));
    QN_TRY(QN_ALLOCATE(w->reaches, pairs));
    QN_TRY(QN_ALLOCATE(w->wall_laws, touches));
    QN_TRY(QN_ALLOCATE(w->wall_pairs, touches));
    QN_TRY(pairs_of_classes(w));
    return pairs_of_walls(w);
}

// Elastic force and energy of one contact at the overlap where a run stops.
static qn_normal at_the_guard(qn_law law, const qn_pair *p, double radius)
{
    return qn_normal_at(law.normal, p, QN_OVERLAP_STOP * radius);
}

// The power of two just above x; above next to nothing where x is 0, as in a world without contacts.
static double power_above(double x)
{
    return ldexp(1, ilogb(qn_max(x, 1e-200)) + 1);
}

void qn_units_choose(qn_world *w, int64_t count, double lever)
{
    int n = w->class_count;
    double energy = 0, largest = 0;  // J, N   of one contact at the guard
    for (int a = 0; a < n; a++) {
        qn_class *c = &w->classes[a];
        double force = 0;  // N   likewise
        for (int b = 0; b < n + w->surface_count; b++) {
            bool wall = b >= n;
            int k = wall ? (b - n) * n + a : a * n + b;
            double radius = wall ? c->radius : qn_min(c->radius, w->classes[b].radius);
            qn_normal f = at_the_guard(wall ? w->wall_laws[k] : w->laws[k],
                                       wall ? &w->wall_pairs[k] : &w->pairs[k], radius);
            force = qn_max(force, f.elastic);
            energy = qn_max(energy, f.energy);
        }
        // A sum of 16 contacts at the guard stays below 2^62 quanta; one is then some 1e-10 of the
        // weight of a glass ball, 1e-15 of a hard impact.
        largest = qn_max(largest, force);
        c->force_unit = power_above(force * 16 * 0x1p-62);
        c->torque_unit = power_above(c->force_unit * c->radius);
    }
    // A part's torque has room for every particle at the guard at the full lever; an energy sum for 64
    // contacts at the guard, or a bed of overlaps near 5 %, and what is below its quantum is summed
    // again in smaller quanta (kernel.h).
    double many = 64 + (double)count;
    w->part_torque_unit = power_above(largest * lever * many * 0x1p-61);
    w->part_force_unit = power_above(largest * many * 0x1p-61);
    // No contact works more in a step than the guard's force along the way at which a step is refused.
    w->wear.unit = power_above(largest * w->largest_radius * 0x1p-56);
    w->energy_unit = power_above(energy * (64 + 0.05 * (double)count) * 0x1p-52);
}
