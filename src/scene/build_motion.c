// SPDX-License-Identifier: Apache-2.0
// Speeds and motions: schedules of legs, of the drum and of walls, and how a wall moves.
#include "scene/build.h"

#include <stddef.h>

_Static_assert(sizeof(qn_leg_keys) == sizeof(qn_stretch_keys)
                   && offsetof(qn_leg_keys, at) == offsetof(qn_stretch_keys, at),
               "legs of drum and walls have the same keys");

static void add_leg(qn_leg *legs, int *count, double duration, double from, double to)
{
    if (*count < QN_LEGS_MAX) legs[(*count)++] = (qn_leg){duration, from, to};
}

void qn_build_legs(double settle, double ramp, double speed, qn_leg *legs, int *count)
{
    if (settle > 0) add_leg(legs, count, settle, 0, 0);
    if (ramp > 0) add_leg(legs, count, ramp, 0, speed);
    add_leg(legs, count, HUGE_VAL, speed, speed);
}

static double last_speed(const qn_leg *legs, int count)
{
    return count > 0 ? legs[count - 1].to : 0;
}

static void read_leg(qn_reader *r, qn_section_id section, qn_section_from from, qn_speed_of *speed,
                     int wanted, qn_leg *legs, int *count)
{
    qn_leg_keys k;
    qn_section_read(r, section, from, &k);
    if (k.at.set && (k.from.node || k.to.node)) {
        qn_complain(r, &k.at, "is a constant speed: leave out from and to");
        return;
    }
    if (!k.at.set && !k.to.set && !k.at.node && !k.to.node) {
        qn_complain_at(r, from.mark, "%s lacks the key 'to' or 'at': the speed of this leg",
                       from.path);
        return;
    }
    if (!k.duration.set && from.node->next && !k.duration.node)
        qn_complain_at(r, from.mark,
                       "%s lacks the key 'duration', which only the last may leave out", from.path);
    double to = speed(r, k.at.set ? &k.at : &k.to, wanted);
    double start = k.at.set     ? to
                   : k.from.set ? speed(r, &k.from, wanted)
                                : last_speed(legs, *count);
    if (!k.duration.set && start != to && !k.duration.node)
        qn_complain_at(r, from.mark, "%s changes the speed, so it needs the key 'duration'",
                       from.path);
    add_leg(legs, count, k.duration.set ? k.duration.number : HUGE_VAL, start, to);
}

void qn_build_schedule(qn_reader *r, const qn_value *schedule, qn_section_id section,
                       qn_speed_of *speed, int wanted, qn_leg *legs, int *count)
{
    const char *path = qn_section_under(r, schedule).path;
    int n = 0;
    for (const qn_node *c = schedule->node->first; c; c = c->next, n++) {
        if (n == QN_LEGS_MAX - 1 && c->next) {
            qn_complain_at(r, c->mark, "%s has more than %d legs", path, QN_LEGS_MAX);
            return;
        }
        read_leg(r, section, qn_section_entry(r, path, c, n), speed, wanted, legs, count);
    }
    if (n == 0) qn_complain(r, schedule, "has no leg");
    if (*count == QN_LEGS_MAX && isfinite(legs[QN_LEGS_MAX - 1].duration))
        qn_complain(r, schedule, "has no room for a leg after the last: leave out its duration");
    double last = last_speed(legs, *count);
    if (*count > 0 && isfinite(legs[*count - 1].duration))
        add_leg(legs, count, HUGE_VAL, last, last);
}

/// A number that must be of one dimension, that of the motion's kind.
static double number_of(qn_reader *r, const qn_value *v, int wanted)
{
    if (v->set && v->dimension != wanted)
        qn_complain(r, v, "is %s, but this kind of motion needs %s",
                    qn_dimension_text(v->dimension), qn_dimension_text(wanted));
    return v->number;
}

/// Says which keys do not go with a kind of motion.
static void refuse(qn_reader *r, const qn_value *const *keys, int count, const char *kind)
{
    for (int i = 0; i < count; i++)
        if (keys[i]->node) qn_complain(r, keys[i], "means nothing for the kind %s", kind);
}

static void need(qn_reader *r, const qn_value *v, qn_section_from from, const char *kind)
{
    if (!v->set && !v->node)
        qn_complain_at(r, from.mark, "%s lacks the key '%s', which the kind %s needs", from.path,
                       v->key->name, kind);
}

static qn_vec3 direction_of(qn_reader *r, const qn_value *v)
{
    qn_vec3 u = qn_vector_of(v);
    double length = qn_norm(u);
    if (v->set && length > 0 && isfinite(length)) return qn_scale(1 / length, u);
    if (v->set) qn_complain(r, v, "has no direction; give a vector that is not zero");
    return qn_v3(0, 0, 1);
}

static void read_speed(qn_reader *r, const qn_motion_keys *k, qn_section_from from, int wanted,
                       qn_drive_def *d)
{
    if (k->schedule.node) {
        const qn_value *const besides[] = {&k->speed, &k->settle, &k->ramp};
        for (int i = 0; i < 3; i++)
            if (besides[i]->node)
                qn_complain(r, besides[i],
                            "cannot stand beside the schedule, which gives all speeds");
        if (k->schedule.set)
            qn_build_schedule(r, &k->schedule, QN_SECTION_STRETCH, number_of, wanted, d->legs,
                              &d->leg_count);
        return;
    }
    if (!k->speed.set && !k->speed.node)
        qn_complain_at(r, from.mark, "%s lacks the key 'speed' (or 'schedule')", from.path);
    double speed = number_of(r, &k->speed, wanted);
    qn_build_legs(k->settle.number, k->ramp.number, speed, d->legs, &d->leg_count);
}

void qn_build_motion(qn_reader *r, const qn_value *motion, qn_drive_def *d)
{
    if (!motion->node) return;
    qn_motion_keys k;
    qn_section_from from = qn_section_under(r, motion);
    qn_section_read(r, QN_SECTION_MOTION, from, &k);
    if (!k.kind.set) return;
    bool turns = k.kind.choice < 2, steady = k.kind.choice == 0 || k.kind.choice == 2;
    const qn_value *const of_turning[] = {&k.axis, &k.through}, *const of_going[] = {&k.direction};
    const qn_value *const of_speed[] = {&k.speed, &k.schedule, &k.ramp};
    const qn_value *const of_swinging[] = {&k.amplitude, &k.frequency, &k.phase};
    const char *kind = k.kind.text;
    d->kind = QN_DRIVE_ROTATE + (qn_drive)k.kind.choice;
    if (turns)
        refuse(r, of_going, 1, kind);
    else
        refuse(r, of_turning, 2, kind), need(r, &k.direction, from, kind);
    d->axis = direction_of(r, turns ? &k.axis : &k.direction);
    if (turns) d->through = qn_vector_of(&k.through);
    if (steady) {
        refuse(r, of_swinging, 3, kind);
        read_speed(r, &k, from, turns ? QN_DIMENSION_SPIN : QN_DIMENSION_VELOCITY, d);
        return;
    }
    refuse(r, of_speed, 3, kind);
    need(r, &k.amplitude, from, kind);
    need(r, &k.frequency, from, kind);
    d->amplitude = number_of(r, &k.amplitude, turns ? QN_DIMENSION_ANGLE : QN_DIMENSION_LENGTH);
    d->frequency = k.frequency.set ? k.frequency.number : 1;
    d->phase = k.phase.number;
    d->start = k.settle.number;
}
