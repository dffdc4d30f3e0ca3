// SPDX-License-Identifier: Apache-2.0
// When two touches of one sphere with a wall are one contact.
#ifndef QN_WORLD_TOUCH_H
#define QN_WORLD_TOUCH_H

/// Two nearest points of one sphere closer together than this share of its radius are one contact,
/// the nearer. Without it each joint of a finely faceted curved wall (bent inwards by less than about
/// 3 degrees) would push with the full force of both its facets.
#define QN_ONE_CONTACT 0.05

#endif
