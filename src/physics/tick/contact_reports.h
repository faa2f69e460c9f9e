#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/world/contact.h"
#include "physics/world/world.h"

/// What becomes of the contacts of a tick. Inside a solver bodies go by index, outside by id.
namespace carom {

/// Gives the bodies their ids.
void name_bodies(const World& world, std::span<Contact> contacts);

/// Adds the contacts to the counts of collisions.
void count_collisions(World& world, std::span<const Contact> contacts);

/// Puts the places within the torus, if there is one: a solver names the place of a contact in
/// whichever period it has found it.
void wrap_points(const std::optional<Box>& torus, std::span<Contact> contacts);

/// The ids of the balls, each once, in ascending order, behind those that `named` has.
void name_standing(const World& world, std::span<const std::uint32_t> balls,
                   std::vector<BallId>& named);

}  // namespace carom
