#pragma once
#include "base/location.h"
#include "track/description.h"

// Data that an unlinked balise group sent (3.6.4.7): linking does not know their reference, so that they move in the
// track frame when the position refers to another group.
namespace evc::track {

/// The places of `contents` hang on an unlinked group (Anchor::received).
void hang_on_unlinked(Contents& contents);

/// New data of an unlinked group (Anchor::received) whose distance to the reference of the position was measured
/// (3.7.3.1.1 to 3.7.3.1.4 of 4.0.0): between the nearest and the farthest place at which they can begin the lower of
/// the stored and the new data counts. SSP and gradient of `contents` become that, where `relocate` would move them,
/// and hang on `then`; ASP and PBD replace from the farthest place on, as their elements may overlap. To be stored
/// next.
void overlap(const Description& d, Contents& contents, Anchor then, const Relocation& by);

/// Moves the stored data that hang on `of`; they hang on `then` from now on. By Table 2a of 4.0.0 (3.6.4.2.4): what is
/// compared with the max safe front end (start of a restriction) moves nearer, what is compared with the min safe one
/// (its end) farther, and what is compared with the estimated one by the shift alone. What is compared with more than
/// one of them (end of the authority, start of a mode profile area) takes the nearest place of all. Changes of a
/// continuous profile that overtake each other leave the lower parts (3.6.4.2.6 of 4.0.0).
void relocate(Description& d, Anchor of, Anchor then, const Relocation& by);

}  // namespace evc::track
