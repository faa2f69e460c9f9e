#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/world/contact.h"

/// Compares two runs from one start by the order of contacts. Only the order of the contacts of one
/// ball matters: swapping two contacts that share no ball changes nothing.
namespace carom {

/// A contact, reduced to the data that its order depends on.
struct Meeting {
    double time = 0.0;  ///< s since the start
    ContactKind kind = ContactKind::ball_ball;
    std::uint32_t a = 0;  ///< as in Contact
    std::uint32_t b = 0;
};

/// Appends `contacts`, in their order.
void note_meetings(std::vector<Meeting>& meetings, std::span<const Contact> contacts);

/// The differences between the contacts of a run and the true ones. The k-th contact of two bodies
/// in one run is paired with their k-th contact in the other.
struct OrderFaults {
    std::size_t missed = 0;  ///< true contacts without a counterpart in the run
    std::size_t extra = 0;   ///< contacts of the run without a true counterpart
    /// Paired contacts outside a longest increasing subsequence of a ball's contacts: the fewest
    /// that must be removed to leave the rest in the true order.
    std::size_t out_of_order = 0;
};
/// Pre: both are in the order in which the solver made them. Cost: n log n.
OrderFaults order_faults(std::span<const Meeting> truth, std::span<const Meeting> given);

/// The first contact, over all balls, in which a ball hits another body than its counterpart does.
struct FirstDifference {
    std::uint32_t ball = 0;
    std::optional<Meeting> first;   ///< in the first run; none: the ball hits nothing more
    std::optional<Meeting> second;  ///< in the second run
    double time = 0.0;              ///< of the earlier of the two contacts
};
/// Consecutive contacts of a ball with the same body count as one, since solvers report resting
/// balls differently. A contact at or after `until` in only one run is not a difference: the other
/// run may be about to have it.
std::optional<FirstDifference> first_difference(std::span<const Meeting> first,
                                                std::span<const Meeting> second, double until);

}  // namespace carom
