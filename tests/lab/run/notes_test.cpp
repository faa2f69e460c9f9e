#include "lab/run/notes.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>

using namespace carom;

namespace {

// A tick with a note of one kind, of `count` things.
TickNotes with(NoteKind kind, std::size_t count = 1) {
    TickNotes notes{.solver = SolverKind::contact};
    switch (kind) {
        case NoteKind::ignores_modulus:
            notes.ignores_modulus = true;
            break;
        case NoteKind::actions_left_out:
            notes.actions_left_out = count;
            break;
        case NoteKind::not_held:
            notes.too_small = count;
            break;
        case NoteKind::stood_still:
            notes.standing.balls = count;
    }
    return notes;
}

std::string report_of(const RunNotes& notes) {
    JsonWriter json;
    write_notes(json, notes);
    return std::move(json).text();
}

}  // namespace

TEST_CASE("notes: a run, its report and play show every kind") {
    for (std::size_t at = 0; at < note_kinds; ++at) {
        CAPTURE(at);
        const TickNotes tick = with(static_cast<NoteKind>(at), 1'000'000);
        RunNotes notes;
        notes.add({}, 1);
        CHECK(notes_text(notes, 100.0).empty());
        CHECK(report_of(notes).find("kind") == std::string::npos);
        notes.add(tick, 2);
        CHECK(notes_text(notes, 100.0).starts_with("note: "));
        CHECK(report_of(notes).find("\"kind\": ") != std::string::npos);
        const auto shown = play_note({}, tick);
        REQUIRE(shown);
        CHECK(shown->has_begun);
        CHECK(shown->text.size() > 20);
        CHECK(shown->text.size() <= 60);
    }
}

TEST_CASE("notes: play says in plain words that a crowd of balls halts, in experiments precisely") {
    const TickNotes tick = with(NoteKind::stood_still, 12);
    CHECK(play_note({}, tick)->text == "Crowded: 12 balls stood still for a tick.");
    CHECK(play_note({}, tick, PlayPurpose::experiment)->text ==
          "Time stood still for 12 balls: too many collisions.");
}

TEST_CASE("notes: a game is not told that a ball stood still, but all else that it can mend") {
    CHECK_FALSE(play_note({}, with(NoteKind::stood_still), PlayPurpose::game));
    for (const NoteKind kind :
         {NoteKind::ignores_modulus, NoteKind::actions_left_out, NoteKind::not_held})
        CHECK(play_note({}, with(kind), PlayPurpose::game));
}

TEST_CASE("notes: ticks are counted from the first, with the most of them") {
    RunNotes notes;
    notes.add(with(NoteKind::stood_still, 3), 7);
    notes.add({}, 8);
    TickNotes last = with(NoteKind::stood_still, 5);
    last.standing.seesaws = 1;
    notes.add(last, 9);
    CHECK(notes_text(notes, 10.0) ==
          "note: time stood still in 2 ticks, first in tick 7 (0.7 s) for 3 balls, for at most 6 "
          "in one tick: beyond what the solver does in a tick. Their energy is unchanged.\n");
    CHECK(report_of(notes).find(R"("ticks": 2, "first_tick": 7, "balls": 3, "most_balls": 5, )"
                                R"("most_seesaws": 1)") != std::string::npos);
}

TEST_CASE("notes: play tells one when it begins, and again while it lasts unless it always holds") {
    for (std::size_t at = 0; at < note_kinds; ++at) {
        CAPTURE(at);
        const auto kind = static_cast<NoteKind>(at);
        const bool is_constant =
            kind == NoteKind::ignores_modulus || kind == NoteKind::actions_left_out;
        const auto again = play_note(with(kind), with(kind));
        CHECK(again.has_value() == !is_constant);
        CHECK_FALSE((again && again->has_begun));
        CHECK_FALSE(play_note(with(kind), {}));
    }
    // Under another solver it is another limit.
    TickNotes swept = with(NoteKind::not_held);
    swept.solver = SolverKind::swept;
    CHECK(play_note(with(NoteKind::not_held), swept)->has_begun);
}
