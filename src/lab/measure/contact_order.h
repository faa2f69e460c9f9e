#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/world/contact.h"

/// The order of contacts, by which two runs from one start are compared. Only the order of the
/// contacts of one ball matters: swapping two contacts that share no ball changes nothing.
namespace carom {

/// A contact, reduced to what its order depends on.
struct Meeting {
    double time = 0.0;  ///< s since the start
    ContactKind kind = ContactKind::ball_ball;
    std::uint32_t a = 0;  ///< as in Contact
    std::uint32_t b = 0;
};

/// Appends `contacts`, in their order.
void note_meetings(std::vector<Meeting>& meetings, std::span<const Contact> contacts);

/// How the contacts of a run differ from the true ones. The k-th contact of two bodies in one run
/// is paired with their k-th contact in the other.
struct OrderFaults {
    std::size_t missed = 0;  ///< true contacts without a partner in the run
    std::size_t extra = 0;   ///< contacts of the run without a true partner
    /// Paired contacts that are not in a longest increasing subsequence of a ball's contacts: as
    /// many as would have to go for the rest to be in the true order.
    std::size_t out_of_order = 0;
};
/// Pre: both are in the order in which the solver made them. Cost: n log n.
OrderFaults order_faults(std::span<const Meeting> truth, std::span<const Meeting> given);

/// The first contact, over all balls, in which a ball hits another body than its twin does.
struct FirstDifference {
    std::uint32_t ball = 0;
    std::optional<Meeting> first;   ///< in the first run; none: it hits nothing more
    std::optional<Meeting> second;  ///< in the second run
    double time = 0.0;              ///< of the earlier of the two
};
/// Several contacts in a row of a ball with the same body count as one, since solvers report
/// resting balls differently. A contact at or after `until` in one run only is no difference: the
/// other run may be about to have it.
std::optional<FirstDifference> first_difference(std::span<const Meeting> first,
                                                std::span<const Meeting> second, double until);

}  // namespace carom
