// SPDX-License-Identifier: Apache-2.0
// What will happen: the numbers that follow from a scene before a single step is done.
//
// For `quern check`, and for what a run says at its start. Costs of a run are estimates; everything
// else is what the run will really use.
#ifndef QN_SCENE_FORECAST_H
#define QN_SCENE_FORECAST_H

#include "world/timestep.h"

typedef struct qn_forecast {
    double critical_speed;       // rad/s  sqrt(2 g/D); 0 without a drum
    double speed;                // rad/s  of the drum in the end
    double revolutions;          // 1      of the drum in the whole run
    int64_t particles, spheres;  // 1  a clump is one particle of several spheres
    double mass;                 // kg     of all particles
    double filling;        // 1      bed volume, voids included, over the drum's; 0 without a drum
    qn_timestep timestep;  //        Rayleigh and contact times, impact speed
    double dt;             // s
    double end;            // s
    int64_t steps;
    double fields_start, fields_end;  // s  when voxel fields are sampled; INFINITY for never
    double wall_time;     // s      estimate, at QN_FORECAST_RATE, without drawing pictures
    double memory, disk;  // bytes  estimates
} qn_forecast;

#define QN_FORECAST_RATE 7e6  // 1/s   particle-steps per second and thread that an estimate assumes

/// What limits the time step. To be asked before qn_world_create(), which takes the walls and lists of
/// spheres from the definition.
QN_NODISCARD qn_status qn_forecast_timestep(const qn_def *def, qn_timestep *timestep);

qn_forecast qn_forecast_of(const qn_world *world, const qn_timestep *timestep);

/// The two sides of a contact entry of the definition and what its law makes of them. Where the two
/// materials meet as particles these are the first classes of both; else a class and a wall.
typedef struct qn_forecast_pair {
    bool is_used;  // particles of one material meet particles or a wall of the other
    bool is_wall;
    qn_sides sides;
    qn_pair pair;
} qn_forecast_pair;

qn_forecast_pair qn_forecast_pair_of(const qn_world *world, const qn_contact_def *contact);

/// How stiff a dashpot is for the time step: 2 zeta omega dt, pi/omega being the time of the hardest
/// contact were nothing lost in it. Tried with balls falling into a box, by restitution: at 0.05 with 40
/// steps in a contact it is 0.3 and the energy balance is off by 3 %; at 0.01 it is 0.8, and 24 %; at 0.002
/// it is 1.7, and the bed explodes. A single collision gains energy from 1 (linear) or 1.4 (Hertz) on.
double qn_forecast_dashpot(const qn_forecast *forecast, const qn_contact_def *contact,
                           const qn_forecast_pair *pair);

/// Fills in wall time, memory and disk; the rest must be there.
void qn_forecast_costs(const qn_world *world, qn_forecast *forecast);

/// A span of the definition in seconds; INFINITY for turns that the drum never makes.
double qn_forecast_seconds(const qn_world *world, qn_span span);

#endif
