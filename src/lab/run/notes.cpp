#include "lab/run/notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "lab/run/promise.h"
#include "level/scene/rules.h"

namespace carom {
namespace {

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// "2 balls", "1 seesaw", "2 balls and 1 seesaw".
std::string text_of(const Standing& standing) {
    if (standing.seesaws == 0) return counted(standing.balls, "ball");
    const std::string seesaws = counted(standing.seesaws, "seesaw");
    if (standing.balls == 0) return seesaws;
    return counted(standing.balls, "ball") + " and " + seesaws;
}

std::size_t total(const Standing& standing) {
    return standing.balls + standing.seesaws;
}

struct NoteRow {
    std::string_view name;
    /// Whether the note holds of every tick under a solver, so that play tells it only once.
    bool is_constant;
    /// Of how many things a tick says so; 0: it does not.
    Standing (*count)(const TickNotes& notes);
    std::string (*in_run)(const RunNotes& notes, const RunNotes::Ticks& ticks, double rate);
    std::string (*in_play)(const TickNotes& notes);
    void (*in_report)(JsonWriter& json, const RunNotes& notes, const RunNotes::Ticks& ticks);
    /// In play of an experiment; null: as in all play.
    std::string (*in_experiment)(const TickNotes& notes) = nullptr;
    bool is_told_in_games = true;
};

constexpr std::array<NoteRow, note_kinds> rows{{
    {.name = "ignores_modulus",
     .is_constant = true,
     .count = [](const TickNotes& notes) -> Standing {
         return {notes.ignores_modulus, 0};
     },
     .in_run = [](const RunNotes& notes, const RunNotes::Ticks&, double) -> std::string {
         return fmt::format(
             "under {} impacts take no time, although the level says use modulus: "
             "only event knows it.",
             name(notes.last.solver));
     },
     .in_play = [](const TickNotes& notes) -> std::string {
         return fmt::format("{} ignores use modulus: impacts take no time.", name(notes.solver));
     },
     .in_report = [](JsonWriter& json, const RunNotes& notes,
                     const RunNotes::Ticks&) { json.field("solver", name(notes.last.solver)); }},
    {.name = "actions_left_out",
     .is_constant = true,
     .count = [](const TickNotes& notes) -> Standing {
         return {notes.actions_left_out, 0};
     },
     .in_run = [](const RunNotes& notes, const RunNotes::Ticks&, double) -> std::string {
         return fmt::format(
             "the rules ask for more than {} actions in a tick, first in tick {}: {} "
             "were left out.",
             most_actions_in_a_tick, notes.last.first_left_out, notes.last.actions_left_out);
     },
     .in_play = [](const TickNotes&) -> std::string {
         return fmt::format("Rules ask for over {} actions in a tick: some left out.",
                            most_actions_in_a_tick);
     },
     .in_report =
         [](JsonWriter& json, const RunNotes& notes, const RunNotes::Ticks&) {
             json.field("actions", notes.last.actions_left_out);
             json.field("first_tick", notes.last.first_left_out);
         }},
    {.name = "not_held",
     .is_constant = false,
     .count = [](const TickNotes& notes) -> Standing {
         return {notes.too_small, 0};
     },
     .in_run = [](const RunNotes& notes, const RunNotes::Ticks& ticks, double) -> std::string {
         return fmt::format(
             "gravity moves small balls too far in a tick for {}, in {}, first in "
             "tick {}, at most {} in one tick: they may sink into others, and gain "
             "energy. More ticks a second help.",
             name(notes.last.solver), counted(ticks.count, "tick"), ticks.first,
             text_of(ticks.most));
     },
     .in_play = [](const TickNotes& notes) -> std::string {
         return fmt::format("Too small for {} at this rate: {} may sink.", name(notes.solver),
                            counted(notes.too_small, "ball"));
     },
     .in_report =
         [](JsonWriter& json, const RunNotes&, const RunNotes::Ticks& ticks) {
             json.field("ticks", ticks.count);
             json.field("first_tick", ticks.first);
             json.field("most_balls", std::uint64_t{ticks.most.balls});
         }},
    {.name = "stood_still",
     .is_constant = false,
     .count = [](const TickNotes& notes) -> Standing { return notes.standing; },
     .in_run = [](const RunNotes&, const RunNotes::Ticks& ticks, double rate) -> std::string {
         return fmt::format(
             "time stood still in {}, first in tick {} ({:.6g} s) for {}, for at "
             "most {} in one tick: beyond what the solver does in a tick. Their "
             "energy is unchanged.",
             counted(ticks.count, "tick"), ticks.first, static_cast<double>(ticks.first) / rate,
             text_of(ticks.in_first), total(ticks.most));
     },
     .in_play = [](const TickNotes& notes) -> std::string {
         return fmt::format("Crowded: {} stood still for a tick.", text_of(notes.standing));
     },
     .in_report =
         [](JsonWriter& json, const RunNotes&, const RunNotes::Ticks& ticks) {
             json.field("ticks", ticks.count);
             json.field("first_tick", ticks.first);
             json.field("balls", std::uint64_t{ticks.in_first.balls});
             json.field("most_balls", std::uint64_t{ticks.most.balls});
             if (ticks.most.seesaws > 0)
                 json.field("most_seesaws", std::uint64_t{ticks.most.seesaws});
         },
     .in_experiment = [](const TickNotes& notes) -> std::string {
         return fmt::format("Time stood still for {}: too many collisions.",
                            text_of(notes.standing));
     },
     .is_told_in_games = false},
}};

}  // namespace

TickNotes notes_of_tick(const World& world, SolverKind solver, Standing standing,
                        const RuleState* rules) {
    return {.solver = solver,
            .ignores_modulus = world.model().modulus.has_value() && solver != SolverKind::event,
            .actions_left_out = rules ? rules->left_out : 0,
            .first_left_out = rules ? rules->first_left_out : 0,
            .too_small = count_too_small(promise_of(solver), world),
            .standing = standing};
}

void RunNotes::add(const TickNotes& notes, std::uint64_t tick) {
    last = notes;
    for (std::size_t kind = 0; kind < note_kinds; ++kind) {
        const Standing count = rows[kind].count(notes);
        if (total(count) == 0) continue;
        Ticks& noted = ticks[kind];
        if (++noted.count == 1) {
            noted.first = tick;
            noted.in_first = count;
        }
        noted.most.balls = std::max(noted.most.balls, count.balls);
        noted.most.seesaws = std::max(noted.most.seesaws, count.seesaws);
    }
}

std::string notes_text(const RunNotes& notes, double rate) {
    std::string text;
    for (std::size_t kind = 0; kind < note_kinds; ++kind)
        if (notes.ticks[kind].count > 0)
            text += "note: " + rows[kind].in_run(notes, notes.ticks[kind], rate) + "\n";
    return text;
}

void write_notes(JsonWriter& json, const RunNotes& notes) {
    json.begin_list(JsonWriter::Layout::lines);
    for (std::size_t kind = 0; kind < note_kinds; ++kind) {
        if (notes.ticks[kind].count == 0) continue;
        json.begin_object(JsonWriter::Layout::one_line);
        json.field("kind", rows[kind].name);
        rows[kind].in_report(json, notes, notes.ticks[kind]);
        json.end_object();
    }
    json.end_list();
}

std::optional<PlayNote> play_note(const TickNotes& before, const TickNotes& now,
                                  PlayPurpose purpose) {
    std::optional<PlayNote> lasting;
    for (const NoteRow& row : rows) {
        const bool is_told = purpose != PlayPurpose::game || row.is_told_in_games;
        if (!is_told || total(row.count(now)) == 0) continue;
        const bool is_new = total(row.count(before)) == 0 || before.solver != now.solver;
        const bool is_precise = purpose == PlayPurpose::experiment && row.in_experiment;
        const auto text = is_precise ? row.in_experiment : row.in_play;
        if (is_new) return PlayNote{text(now), true};
        if (!row.is_constant) lasting = {text(now), false};
    }
    return lasting;
}

}  // namespace carom
