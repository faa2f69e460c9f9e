#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/world/contact.h"

/// Who met whom, and in which order: what two runs from one start are compared by. Only the order
/// of the contacts of one ball means anything: contacts that share no ball may be swapped and
/// nothing changes.
namespace carom {

/// A contact, as far as the order of contacts is concerned.
struct Meeting {
    double time = 0.0;  ///< s since the start
    ContactKind kind = ContactKind::ball_ball;
    std::uint32_t a = 0;  ///< as in Contact
    std::uint32_t b = 0;
};

/// Appends those of `contacts`.
void note_meetings(std::vector<Meeting>& meetings, std::span<const Contact> contacts);

/// The k-th meeting of two bodies in one run is paired with their k-th in the other.
struct OrderFaults {
    std::size_t missed = 0;  ///< of the truth, without a partner in the given
    std::size_t extra = 0;   ///< of the given, without a partner in the truth
    /// Paired, but some ball would have to have fewer of them for the rest of its meetings to stand
    /// in the order of the truth (all but a longest increasing subsequence).
    std::size_t out_of_order = 0;
};
/// Both in the order in which the solver made them.
OrderFaults order_faults(std::span<const Meeting> truth, std::span<const Meeting> given);

/// The first point, over all balls, at which a ball meets another body than its twin does.
struct FirstDifference {
    std::uint32_t ball = 0;
    std::optional<Meeting> first;   ///< what it meets in the first run; none: nothing any more
    std::optional<Meeting> second;  ///< in the second run
    double time = 0.0;              ///< of the earlier of the two
};
/// A ball that meets the same body several times in a row counts as meeting it once, since solvers
/// report a ball that rests differently. A meeting at or after `until` that only one of the two has
/// is no difference: the other may be about to have it.
std::optional<FirstDifference> first_difference(std::span<const Meeting> first,
                                                std::span<const Meeting> second, double until);

}  // namespace carom
