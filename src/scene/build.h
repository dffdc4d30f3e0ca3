// SPDX-License-Identifier: Apache-2.0
// Sections into the definition, each part in its file; called once, in this order, by scene.c.
// What is wrong goes to the messages. Only running out of memory is a status.
#ifndef QN_SCENE_BUILD_H
#define QN_SCENE_BUILD_H

#include "scene/reader.h"

QN_NODISCARD qn_status qn_build_materials(qn_reader *r, const qn_scene_keys *scene);
QN_NODISCARD qn_status qn_build_contacts(qn_reader *r, const qn_scene_keys *scene);
QN_NODISCARD qn_status qn_build_drum(qn_reader *r, const qn_scene_keys *scene);
QN_NODISCARD qn_status qn_build_walls(qn_reader *r, const qn_scene_keys *scene);
QN_NODISCARD qn_status qn_build_particles(qn_reader *r, const qn_scene_keys *scene);
QN_NODISCARD qn_status qn_build_flow(qn_reader *r, const qn_scene_keys *scene);
void qn_build_times(qn_reader *r, const qn_scene_keys *scene);
void qn_build_measure(qn_reader *r, const qn_scene_keys *scene);
void qn_build_output(qn_reader *r, const qn_scene_keys *scene);

/// The shape of a group whose other keys are read, for a definition with room for it.
QN_NODISCARD qn_status qn_build_shape(qn_reader *r, const qn_group_keys *keys, qn_mark mark,
                                      qn_group_def *group);

/// What only shows when everything is known: materials that meet without a law, turns of a drum that
/// never turns.
void qn_build_check(qn_reader *r, const qn_scene_keys *scene);

/// How a wall moves: the value of its key `motion`, which may not be written.
void qn_build_motion(qn_reader *r, const qn_value *motion, qn_drive_def *drive);

/// The number of a speed, with a message where it is not of the dimension wanted.
typedef double qn_speed_of(qn_reader *r, const qn_value *v, int wanted);

/// Legs of a schedule whose entries are read as `section`, and those of rest, ramp and constant speed.
void qn_build_schedule(qn_reader *r, const qn_value *schedule, qn_section_id section,
                       qn_speed_of *speed, int wanted, qn_leg *legs, int *count);
void qn_build_legs(double settle, double ramp, double speed, qn_leg *legs, int *count);

/// Index of the material a key names, -1 where that could not be read.
static inline int qn_material_of(const qn_value *v)
{
    return v->set ? v->choice : -1;
}

static inline qn_vec3 qn_vector_of(const qn_value *v)
{
    return qn_v3(v->vector[0], v->vector[1], v->vector[2]);
}

/// A span as the definition wants it.
qn_span qn_span_of(const qn_value *v);

/// Name of a file of the scene, relative to the working directory; false, with a message, if it is
/// too long or files must not be read.
bool qn_file_of(qn_reader *r, const qn_value *v, char path[QN_PATH_MAX]);

/// Section `id` of a list or name entry: path "drum.schedule[2]" or "walls.floor".
qn_section_from qn_section_entry(qn_reader *r, const char *parent, const qn_node *node, int index);

#endif
