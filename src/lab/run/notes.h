#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "game/rules/rule_state.h"
#include "lab/json.h"
#include "physics/solver.h"
#include "physics/world/world.h"

/// Notes: where a limit bites, or a solver cannot do what the level says, a run says so, and play
/// shows it. Every kind of note is a row of one table, which has its text in a run, its text in
/// play and its object in a report, so that none is left out.
namespace carom {

/// In the order in which they are told.
enum class NoteKind : std::uint8_t {
    ignores_modulus,   ///< the level says `use modulus`, and the solver lets impacts take no time
    actions_left_out,  ///< rules asked for more actions than a tick may carry out
    not_held,          ///< balls are too small for what the solver promises (Promise::most_fall)
    stood_still        ///< time stood still for balls or seesaws (Solver::standing)
};
inline constexpr std::size_t note_kinds = 4;

/// What is noteworthy of one tick.
struct TickNotes {
    SolverKind solver = SolverKind::event;
    bool ignores_modulus = false;
    std::uint64_t actions_left_out = 0;  ///< so far
    std::uint64_t first_left_out = 0;    ///< the tick of the first of them
    std::size_t too_small = 0;           ///< balls
    Standing standing;
};

/// The notes of the tick that `world` has just completed, of a level with these rules or none.
TickNotes notes_of_tick(const World& world, SolverKind solver, Standing standing,
                        const RuleState* rules);

/// What is noteworthy of the ticks of a run.
struct RunNotes {
    /// Ticks with a note of one kind.
    struct Ticks {
        std::uint64_t count = 0;
        std::uint64_t first = 0;  ///< from 1
        Standing in_first;        ///< balls and seesaws in the first of them
        Standing most;            ///< in any of them
    };
    TickNotes last;
    std::array<Ticks, note_kinds> ticks{};  ///< by NoteKind

    const Ticks& of(NoteKind kind) const { return ticks[static_cast<std::size_t>(kind)]; }
    /// Adds a tick.
    void add(const TickNotes& notes, std::uint64_t tick);
};

/// A line for each kind of note, each with "note: ". Empty if nothing is noteworthy.
std::string notes_text(const RunNotes& notes, double rate);

/// The list of notes of a report, as the value of a key.
void write_notes(JsonWriter& json, const RunNotes& notes);

/// What the player does: an experiment is a level that states what it expects, a game one with
/// rules of pool or pinball.
enum class PlayPurpose : std::uint8_t { free_play, experiment, game };

/// What play shows of a tick: the note that has begun, or else one that lasts. At most 60
/// characters. An experiment has precise words; others have plain ones. A game says nothing of time
/// that stands still for a moment, such as for a ball that jams two flippers: the table shows it.
struct PlayNote {
    std::string text;
    bool has_begun = false;  ///< the tick before had no such note
};
std::optional<PlayNote> play_note(const TickNotes& before, const TickNotes& now,
                                  PlayPurpose purpose = PlayPurpose::free_play);

}  // namespace carom
