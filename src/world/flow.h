// SPDX-License-Identifier: Apache-2.0
// Feeds and outlets: what they have done so far, and where a feed can put particles.
//
// step/flow.h acts; here is what survives a checkpoint and what measures ask for.
#ifndef QN_WORLD_FLOW_H
#define QN_WORLD_FLOW_H

#include "base/column.h"
#include "world/world.h"

/// One feed while running.
typedef struct qn_feed {
    int site_count;
    qn_vec3 *sites;   // m   centres where the largest sphere fits beside its neighbours; owned
    double radius;    // m   of the largest with its padding: half the width of a site's cell
    int first_class;  //     of its group
    int64_t stride;   //     steps between its occasions
} qn_feed;

struct qn_flow {
    int feed_count, outlet_count, class_count;
    qn_feed *feeds;         //     owned
    int64_t outlet_stride;  //     steps between looks at the outlets
    int64_t most;           //     particles there may be at the end of the run, about
    bool *gone;             //     by particle: leaves at the end of this step; owned
    int64_t gone_room;
    int gone_count;
    // Kept in a checkpoint.
    int64_t next_id;
    int64_t *fed;      //     [feed * class_count + class]; owned
    int64_t *taken;    //     [outlet * class_count + class]; owned
    double energy[2];  // J   kinetic and gravity's of what came in; all of what went out
};

/// Prepares the feeds and outlets of the definition; leaves world->flow NULL where there are none.
/// QN_INPUT where a feed has no room for a single sphere, in its region or within the walls.
QN_NODISCARD qn_status qn_flow_create(qn_world *world);
void qn_flow_destroy(qn_flow *flow);

/// Energy (J) that feeds have brought in and outlets have taken out; 0 without any.
double qn_flow_energy_in(const qn_world *world);
double qn_flow_energy_out(const qn_world *world);

/// Particles and mass (kg) that a feed has given or an outlet has taken.
int64_t qn_flow_count(const qn_world *world, const int64_t *by_class);
double qn_flow_mass(const qn_world *world, const int64_t *by_class);

/// What a feed should give until time t (s), by its rate: kg or particles.
double qn_flow_asked(const qn_world *world, int feed, double t);

/// What a feed gives in the whole run if its places are never full: spheres, about, and their mass (kg).
void qn_flow_expected(const qn_world *world, int feed, double *spheres, double *mass);

/// Whether a feed has given less than asked until now, by more than its next sphere and what falls due
/// between two occasions: its places were full. Both in kg or particles, as its rate is.
bool qn_flow_is_short(const qn_world *world, int feed, double *given, double *asked);

/// The same of all feeds (0) or all outlets (1).
double qn_flow_total_count(const qn_world *world, int which);
double qn_flow_total_mass(const qn_world *world, int which);

/// Particles (1) there may be at most, those of now without feeds: for the size of sums and of a run.
int64_t qn_flow_most(const qn_world *world);

/// What must survive a checkpoint, as columns that point into the flow. Returns how many.
enum { QN_FLOW_COLUMNS = 4 };
int qn_flow_columns(qn_flow *flow, qn_column columns[QN_FLOW_COLUMNS]);

#endif
