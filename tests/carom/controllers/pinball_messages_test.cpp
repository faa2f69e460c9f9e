#include "carom/controllers/pinball_messages.h"

#include <doctest/doctest.h>

#include <string>

#include "carom/support/at_table.h"

using namespace carom;
using namespace carom::test;

namespace {

using Moment = ScorePanel::Moment;

// From the launch on, a message at each of these times.
const char* const talk = R"(timer first 1s
timer second 1.06s
timer third 1.1s
on ball launch start first, start second, start third
)";

std::string with_rules(const std::string& rules) {
    return level + std::string(talk) + rules;
}

/// Pulls the plunger and lets it go.
void launch(Session& session) {
    for (const bool is_down : {true, false}) {
        for (int tick = 0; tick < 500; ++tick)
            session.step_forward();
        REQUIRE_FALSE(session.apply(command::Press{Button::plunger, is_down}).has_value());
    }
}

void hear(PinballMessages& messages, Session& session, double seconds) {
    const auto ticks = static_cast<int>(seconds * session.world().rate());
    for (int tick = 0; tick < ticks; ++tick) {
        session.step_forward();
        messages.follow(session);
    }
}

}  // namespace

TEST_CASE("a message can be read before the next one takes its place") {
    Session session = session_of(with_rules("on first ends message \"A MODE BEGINS\"\n"
                                            "on second ends message \"KICKBACK LIT\"\n"
                                            "on third ends message \"COMBO\"\n")
                                     .c_str());
    PinballMessages messages;
    launch(session);
    hear(messages, session, 1.05);
    CHECK(messages.text() == "A MODE BEGINS");
    hear(messages, session, 1.0);
    CHECK(messages.text() == "A MODE BEGINS");
    hear(messages, session, 0.5);
    CHECK(messages.text() == "KICKBACK LIT");
    hear(messages, session, 1.0);
    CHECK(messages.text() == "COMBO");
    hear(messages, session, 3.0);
    CHECK(messages.text().empty());
}

TEST_CASE("a jackpot is shown before a lesser message, which follows it") {
    Session session =
        session_of(with_rules("on first ends message \"KICKBACK LIT\"\n"
                              "on second ends score 15000, message \"JACKPOT 15,000\"\n")
                       .c_str());
    PinballMessages messages;
    launch(session);
    hear(messages, session, 1.1);
    CHECK(messages.text() == "JACKPOT 15,000");
    CHECK(messages.moment() != Moment::plain);
    hear(messages, session, 1.9);
    CHECK(messages.text() == "KICKBACK LIT");
    CHECK(messages.moment() == Moment::plain);
}

TEST_CASE("many points without a message celebrate nothing, least of all the message before") {
    Session session = session_of(
        with_rules("on first ends message \"A RIDE\"\non second ends score 15000\n").c_str());
    PinballMessages messages;
    launch(session);
    hear(messages, session, 1.1);
    CHECK(messages.text() == "A RIDE");
    CHECK(messages.moment() == Moment::plain);
}

TEST_CASE("a game that is resumed does not celebrate what it had scored before") {
    Session session =
        session_of(with_rules("on first ends score 15000, message \"JACKPOT 15,000\"\n").c_str());
    PinballMessages messages;
    launch(session);
    hear(messages, session, 1.1);
    CHECK(messages.moment() != Moment::plain);
    PinballMessages resumed;
    hear(resumed, session, 0.01);
    CHECK(resumed.text() == "JACKPOT 15,000");
    CHECK(resumed.moment() == Moment::plain);
}

TEST_CASE("a message that waits is forgotten when the player goes back before it") {
    Session session = session_of(with_rules("on first ends message \"A MODE BEGINS\"\n"
                                            "on second ends message \"KICKBACK LIT\"\n")
                                     .c_str());
    PinballMessages messages;
    launch(session);
    hear(messages, session, 1.2);
    CHECK(messages.text() == "A MODE BEGINS");
    for (int tick = 0; tick < 400; ++tick)
        session.step_back();
    messages.follow(session);
    CHECK(messages.text().empty());
}

TEST_CASE("a tilt interrupts every message") {
    Session session = session_of((with_rules("on first ends message \"A MODE BEGINS\"\n"
                                             "on second ends message \"KICKBACK LIT\"\n"))
                                     .c_str());
    PinballMessages messages;
    launch(session);
    hear(messages, session, 1.07);
    for (int nudge = 0; nudge < 8; ++nudge) {
        REQUIRE_FALSE(session.apply(command::Press{Button::nudge_up, true}).has_value());
        hear(messages, session, 0.12);
        REQUIRE_FALSE(session.apply(command::Press{Button::nudge_up, false}).has_value());
    }
    CHECK(messages.text() == "TILT");
}
