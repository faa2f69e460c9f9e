#include "carom/play/player.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "carom/context/solver_choice.h"
#include "carom/support/person.h"
#include "game/support/scenes.h"
#include "physics/world/fingerprint.h"

using namespace carom;
using carom::test::always;
using carom::test::ascii_view;
using carom::test::busy_box;

namespace {

struct Person : test::PersonAtWindow {
    Person() : PersonAtWindow(Session(busy_box(), {.kind = SolverKind::swept}), 80, 24) {}

    void keys(const std::u32string& all) {
        for (const char32_t code : all)
            key(code);
    }
    Vec2 ball(std::uint32_t number) const {
        return world().balls().position[*index_of(world(), BallId{number})];
    }
    std::uint64_t tick() const { return world().tick(); }
};

bool is_near(Vec2 a, Vec2 b, double tolerance) {
    return distance(a, b) <= tolerance;
}

}  // namespace

TEST_CASE("time passes, and stops in a pause") {
    Person person;
    person.pass(0.25);
    CHECK(person.tick() == 30);
    person.key(U' ');
    person.pass(0.25);
    CHECK(person.tick() == 30);
    person.key(U' ');
    person.pass(0.25);
    CHECK(person.tick() == 60);
}

TEST_CASE("stepping goes one tick forward and exactly back") {
    Person person;
    person.key(U' ');
    std::vector<std::uint64_t> fingerprints{fingerprint(person.world())};
    for (int i = 0; i < 50; ++i) {
        person.key(U'.');
        fingerprints.push_back(fingerprint(person.world()));
    }
    for (std::size_t i = 50; i-- > 0;) {
        person.key(U',');
        REQUIRE(fingerprint(person.world()) == fingerprints[i]);
    }
    person.key(U',');
    CHECK(person.sees("This is the start"));
}

TEST_CASE("stepping pauses a running game") {
    Person person;
    person.pass(0.25);
    person.key(U'.');
    person.pass(0.25);
    CHECK(person.tick() == 31);
}

TEST_CASE("quit, menu and save are requests") {
    Person person;
    CHECK(person.key(U'q') == PlayRequest::quit);
    CHECK(person.key(key::escape) == PlayRequest::menu);
    CHECK(person.key(U'w') == PlayRequest::save);
    CHECK(person.key(U'm') == PlayRequest::toggle_mouse);
    CHECK(person.key(U'x') == PlayRequest::none);
    CHECK(person.key(U'`') == PlayRequest::none);
}

TEST_CASE("the left button drags a ball, which pushes others out of its way") {
    Person person;
    person.key(U' ');
    // All at rest, so that only the drag moves anything.
    for (std::uint32_t i = 0; i < 9; ++i)
        REQUIRE(person.player.session().world().balls().velocity[i] != Vec2{});
    person.key(U' ');
    person.mouse(InputEvent::Action::press, person.ball(4));
    person.mouse(InputEvent::Action::move, {20.0, 12.0});
    for (int i = 0; i < 60; ++i)
        person.pass(1.0 / 60.0);
    CHECK(is_near(person.ball(4), {20.0, 12.0}, 0.01));
    person.mouse(InputEvent::Action::release, {20.0, 12.0});
    CHECK(person.world().held_balls().empty());
}

TEST_CASE("in a pause a ball is dragged at once, and so is a joint") {
    Person person;
    person.key(U' ');
    person.drag(person.ball(0), {6.0, 4.0});
    CHECK(is_near(person.ball(0), {6.0, 4.0}, 0.01));
    person.drag({30.0, 20.0}, {29.0, 18.0});
    CHECK(is_near(person.world().capsules().shape[5].end, {29.0, 18.0}, 0.01));
    CHECK(person.world().capsules().shape[5].end == person.world().capsules().shape[6].start);
    person.drag({6.0, 4.0}, {13.0, 8.4});
    CHECK(person.sees("it would overlap ball 1"));
}

TEST_CASE("the cue: the right button, or a modifier with the left, or a key") {
    struct Way {
        std::uint8_t button;
        std::uint8_t modifiers;
        bool key;
    };
    for (const Way& way : {Way{3, no_modifier, false}, Way{1, control, false}, Way{1, shift, false},
                           Way{1, no_modifier, true}}) {
        Person person;
        person.key(U' ');
        const Vec2 from = person.ball(4);
        if (way.key) {
            person.mouse(InputEvent::Action::move, {20.0, 27.0}, 0);
            person.key(U'k');
        }
        person.drag(from, from + Vec2{3.0, -1.0}, way.button, way.modifiers);
        CHECK(is_near(person.world().balls().velocity[4], Vec2{-3.0, 1.0} * PointerTool::cue_gain,
                      0.01));
        CHECK(person.ball(4) == from);
    }
}

TEST_CASE("everything works from the keyboard") {
    Person person;
    person.key(U' ');
    SUBCASE("tab goes from ball to ball, enter grabs and drops") {
        person.keys({key::tab, key::tab});
        CHECK(person.player.pointer().at == person.ball(1));
        const Vec2 from = person.ball(1);
        person.key(key::enter);
        for (int i = 0; i < 4; ++i)
            person.key(key::down);
        person.key(key::enter);
        CHECK(person.ball(1).x == doctest::Approx(from.x));
        CHECK(person.ball(1).y < from.y - 1.0);
        CHECK(person.player.pointer().tool.is_empty());
    }
    SUBCASE("k pulls the cue, enter shoots") {
        person.keys({key::tab, U'k', key::left, key::left, key::up, key::enter});
        const Vec2 velocity = person.world().balls().velocity[0];
        CHECK(velocity.x > 0.0);
        CHECK(velocity.y < 0.0);
        CHECK(person.player.pointer().tool.is_empty());
    }
    SUBCASE("escape cancels the shot, then hides the cursor, then leaves the game") {
        const auto before = fingerprint(person.world());
        person.keys({key::tab, U'k', key::left});
        CHECK(person.key(key::escape) == PlayRequest::none);
        CHECK(fingerprint(person.world()) == before);
        CHECK(person.key(key::escape) == PlayRequest::none);
        CHECK(person.key(key::escape) == PlayRequest::menu);
    }
    SUBCASE("e draws an edge") {
        const std::size_t edges = person.world().capsules().size();
        person.mouse(InputEvent::Action::move, {5.0, 24.0}, 0);
        person.keys({U'e', key::right, key::right, key::right, U'e'});
        REQUIRE(person.world().capsules().size() == edges + 1);
        const Capsule& edge = person.world().capsules().shape.back();
        CHECK(edge.end.x > edge.start.x);
    }
}

TEST_CASE("balls and edges are added, removed, and restored") {
    Person person;
    person.key(U' ');
    person.mouse(InputEvent::Action::move, {5.0, 25.0}, 0);
    person.key(U'a');
    CHECK(person.world().balls().size() == 10);
    person.key(U'a');
    CHECK(person.world().balls().size() == 10);
    CHECK(person.sees("it would overlap ball 9"));
    person.key(U'x');
    CHECK(person.world().balls().size() == 9);
    person.key(U'u');
    CHECK(person.world().balls().size() == 10);
    person.key(U'u');
    CHECK(person.world().balls().size() == 9);
    person.mouse(InputEvent::Action::move, {29.0, 5.5}, 0);
    person.key(U'E');
    CHECK(person.world().capsules().size() == 6);
    person.key(U'u');
    CHECK(person.world().capsules().size() == 7);
    person.key(U'u');
    CHECK(person.sees("Nothing to undo"));
}

TEST_CASE("going back releases the held ball, and the game continues without it") {
    Person person;
    person.pass(0.5);
    person.mouse(InputEvent::Action::press, person.ball(4));
    person.pass(0.1);
    REQUIRE(person.world().held_balls().size() == 1);
    person.keys(U",,");
    CHECK(person.player.pointer().tool.is_empty());
    person.key(U' ');
    for (int frame = 0; frame < 30; ++frame)
        person.pass(1.0 / 60.0);
    CHECK(person.world().held_balls().empty());
}

TEST_CASE("gravity is toggled and rotated") {
    Person person;
    person.key(U'g');
    REQUIRE(person.world().model().gravity);
    CHECK(person.world().model().gravity->x == 0.0);
    const double strength = -person.world().model().gravity->y;
    CHECK(strength > 0.0);
    person.key(U'G');
    CHECK(*person.world().model().gravity == Vec2{strength, 0.0});
    person.key(U'g');
    CHECK_FALSE(person.world().model().gravity);
    person.key(U'g');
    CHECK(*person.world().model().gravity == Vec2{strength, 0.0});
}

TEST_CASE("switching goes through all solvers in turn") {
    Person person;
    for (std::size_t i = 0; i < solvers_available().size(); ++i) {
        CHECK(person.sees(solver_text(person.player.session().solver())));
        person.key(U's');
        person.pass(0.1);
    }
    CHECK(person.player.session().solver().kind == SolverKind::swept);
}

TEST_CASE("the wheel zooms at the pointer, the background and the middle button pan") {
    Person person;
    const Vec2 at{10.0, 20.0};
    person.mouse(InputEvent::Action::wheel_up, at, 0);
    const CellPoint place = to_cells(person.player.camera(), at);
    person.look();
    const double before = person.player.camera().columns_per_length;
    person.mouse(InputEvent::Action::wheel_up, at, 0);
    CHECK(person.player.camera().columns_per_length > before);
    CHECK(to_cells(person.player.camera(), at).column == doctest::Approx(place.column));
    CHECK(to_cells(person.player.camera(), at).row == doctest::Approx(place.row));
    const Vec2 middle = person.player.camera().center;
    person.drag({4.0, 26.0}, {6.0, 26.0});
    CHECK(person.player.camera().center.x == doctest::Approx(middle.x - 2.0));
    person.key(U'0');
    person.look();
    CHECK(person.player.camera().center == Vec2{20.0, 15.0});
}

TEST_CASE("found 3: a near miss moves nothing, and panning says how to come back") {
    Person person;
    person.key(U' ');
    person.look();
    const Vec2 ball = person.ball(0);
    const Camera camera = person.player.camera();
    const double column = 1.0 / camera.columns_per_length;
    const double radius = person.world().balls().radius[0];
    // A fingertip beside the ball still grabs it.
    person.drag(ball - Vec2{radius + 2.0 * column, 0.0}, ball - Vec2{radius + 3.0 * column, 0.0});
    CHECK_FALSE(person.ball(0) == ball);
    const Vec2 there = person.ball(0);
    // A place beside a ball, out of reach of everything.
    std::optional<Vec2> beside;
    for (const Vec2 place : person.world().balls().position)
        for (const Vec2 way : {Vec2{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
            const Vec2 at = place + way * (radius + 4.5 * column);
            if (!PointerTool{}.take(person.world(), at, 3.0 * column)) beside = at;
        }
    REQUIRE(beside);
    person.mouse(InputEvent::Action::press, *beside);
    CHECK(person.sees("Missed: nothing under the pointer."));
    CHECK(person.sees(">X<"));
    person.mouse(InputEvent::Action::move, *beside - Vec2{5.0, 0.0});
    person.mouse(InputEvent::Action::release, *beside - Vec2{5.0, 0.0});
    CHECK(person.player.camera().center == camera.center);
    CHECK(person.ball(0) == there);
    person.mouse(InputEvent::Action::press, {4.0, 26.0}, 2);
    CHECK(person.sees("0 brings the whole view back"));
    person.mouse(InputEvent::Action::release, {8.0, 26.0}, 2);
    CHECK(person.sees("0 brings the whole view back"));
}

TEST_CASE("found 13: the collision that n reached is told and marked, undo tells where it leads") {
    Person person;
    person.key(U'n');
    for (int i = 0; i < 100 && !person.sees(" hits "); ++i)
        person.pass(0.1);
    CHECK(person.sees(" hits "));
    CHECK(person.sees(">X<"));
    person.pass(10.0);
    CHECK_FALSE(person.sees(">X<"));
    person.key(U'g');
    person.key(U'u');
    CHECK(person.sees("Undone: back at "));
}

TEST_CASE("found 20: a new edge is thin, keys change its width, and its end is told") {
    Person person;
    person.key(U' ');
    person.keys(U"e");
    const double width = person.player.pointer().tool.edge_width();
    CHECK(width <= 30.0 / 75.0);
    CHECK(width > 0.0);
    person.key(U'+');
    CHECK(person.player.pointer().tool.edge_width() == doctest::Approx(1.25 * width));
    CHECK(person.player.clock().speed() == 1.0);
    person.key(U'-');
    person.key(U'-');
    CHECK(person.player.pointer().tool.edge_width() == doctest::Approx(0.8 * width));
    const std::size_t edges = person.world().capsules().size();
    for (int i = 0; i < 3; ++i)
        person.key(key::right);
    person.key(U'e');
    if (person.world().capsules().size() > edges) CHECK(person.sees("Edge added."));
    CHECK(person.world().capsules().size() == edges + 1);
}

TEST_CASE("a small window asks for more room, and the game waits") {
    Person person;
    person.window = Canvas(19, 30);
    person.look();
    person.pass(1.0);
    CHECK(person.tick() == 0);
    person.window = Canvas(20, 8);
    person.look();
    person.pass(0.1);
    CHECK(person.tick() == 12);
}

TEST_CASE("help lists the keys and scrolls, and any other key goes back") {
    Person person;
    person.key(U'?');
    CHECK(person.sees("grab, release"));
    person.pass(1.0);
    CHECK(person.tick() == 0);
    for (int i = 0; i < 9 && !person.sees("menu, quit"); ++i)
        person.key(key::page_down);
    CHECK(person.sees("menu, quit"));
    person.key(U'x');
    CHECK(person.sees("Busy box"));
    CHECK(person.world().balls().size() == 9);
    person.key(U'?');
    CHECK(person.key(U'q') == PlayRequest::none);
    CHECK(person.sees("Busy box"));
    CHECK(person.key(U'q') == PlayRequest::quit);
}

TEST_CASE("messages fade, and the problem of a watched level stays") {
    Person person;
    person.player.say("hello there");
    CHECK(person.sees("hello there"));
    person.player.set_problem({"busy.level:3:1: error: no", "    3 | ball at=1", "      | ^~~~"});
    person.pass(10.0);
    CHECK(person.sees("busy.level:3:1: error: no"));
    CHECK(person.sees("      | ^~~~"));
    person.player.set_problem({});
    CHECK_FALSE(person.sees("error: no"));
}

TEST_CASE("play shows what a run would note, and leaves room for other messages") {
    Scene scene = busy_box();
    scene.world.edit_definition().model.gravity = Vec2{0.0, -1e9};
    test::PersonAtWindow person(Session(std::move(scene), {.kind = SolverKind::contact}), 80, 24);
    const auto shows = [](const std::string& picture) {
        return picture.find("Too small for contact at this rate: ") != std::string::npos;
    };
    person.pass(0.02);
    CHECK(shows(person.look()));
    person.key(U't');
    person.pass(0.02);
    CHECK_FALSE(shows(person.look()));
}

TEST_CASE("a message that ends a long tick, or comes up behind a page, is seen for its full time") {
    Person person;
    person.player.say("hello there");
    person.player.fade_messages(30.0);  // the tick
    CHECK(person.sees("hello there"));
    person.key(U'?');
    person.player.say("hello again");
    person.player.fade_messages(0.0);
    person.player.fade_messages(30.0);
    person.key(key::escape);
    CHECK(person.sees("hello again"));
    person.pass(30.0);
    CHECK_FALSE(person.sees("hello again"));
}

TEST_CASE("found 4: a message is over when the player does the next thing") {
    Person person;
    person.key(U'e');
    CHECK(person.sees("makes the edge"));
    person.key(key::right);
    CHECK_FALSE(person.sees("makes the edge"));
}

TEST_CASE("found 2: the level's own text is a page, and the help page leads there") {
    Scene scene = test::busy_box();
    scene.comment = {"Goal: keep it busy.", "", "Nine balls.", "", "Try:", "  g   gravity"};
    test::PersonAtWindow person(Session(std::move(scene), {}, 0), 80, 24);
    CHECK(person.sees("keep it busy."));
    person.key(U'?');
    CHECK(person.sees("grab, release"));
    person.key(key::f1);
    CHECK(person.sees("Goal  keep it busy."));
    CHECK(person.sees("g  gravity"));
    CHECK_FALSE(person.sees("grab, release"));
    person.key(key::f1);
    CHECK(person.sees("space pause"));
}

TEST_CASE("a pause uses no time and draws no pictures") {
    Person person;
    person.pass(0.1);
    CHECK(person.player.needs_draw());
    CHECK(person.player.seconds_to_change() == 0.0);
    person.key(U' ');
    person.pass(10.0);
    person.look();
    CHECK_FALSE(person.player.needs_draw());
    CHECK(person.player.seconds_to_change() > 1e6);
    person.pass(1.0);
    CHECK_FALSE(person.player.needs_draw());
}

TEST_CASE("following keeps the ball in the centre") {
    Person person;
    person.keys({key::tab, U'f'});
    for (int i = 0; i < 10; ++i) {
        person.pass(0.1);
        person.look();
        CHECK(person.player.camera().center == person.ball(0));
    }
}

TEST_CASE("a closed box has no drift, and none is claimed while a ball is held") {
    Person person;
    person.pass(1.0);
    CHECK(person.sees("drift"));
    person.mouse(InputEvent::Action::press, person.ball(4));
    person.pass(0.1);
    CHECK_FALSE(person.sees("drift"));
}

TEST_CASE("the status line shows the level's expectations and their state") {
    Scene scene = busy_box();
    Expect balls{"balls", {quantity_named("balls"), {}, {}, {}}, 99.0, 0.0, {}, 1};
    Expect deepest{"overlap", {quantity_named("overlap"), {}, {}, {}}, 0.0, 0.0, {}, 2};
    scene.expects = {balls, deepest};
    const auto seen = [&] {
        Player player(Session(scene, {.kind = SolverKind::swept}), ascii_view(), KeyMap());
        Canvas window(120, 24);
        player.draw(window, 2.0);
        return window.text();
    };
    const std::string wanted = fmt::format("balls {:>2} of 99", scene.world.balls().size());
    CHECK(seen().find(wanted) != std::string::npos);
    CHECK(seen().find("overlap") == std::string::npos);  // only `carom run` measures it
    scene.overridden = true;
    CHECK(seen().find("of 99") == std::string::npos);
}

TEST_CASE("observables are shown, in panels and beside what the level expects") {
    Scene scene = busy_box();
    Show show;
    show.what = Show::What::observable;
    show.observable = Observable::msd;
    scene.shows = {show};
    scene.expects = {{"msd", {quantity_named("msd"), {}, {}, {}}, 1e9, 0.0, {}, 1}};
    Player player(Session(scene, {.kind = SolverKind::swept}), ascii_view(), KeyMap());
    const auto has = [&](std::string_view text) {
        Canvas window(120, 24);
        player.draw(window, 2.0);
        return window.text().find(text) != std::string::npos;
    };
    CHECK(has("mean square displacement"));
    CHECK(has("msd     0 of 1e+09"));
    player.advance(0.5, [] { return true; });
    CHECK_FALSE(has("msd     0 of 1e+09"));
    // A step back begins it anew.
    player.handle({.kind = InputEvent::Kind::key, .key = U','});
    CHECK(has("msd     0 of 1e+09"));
}

TEST_CASE("any keys in any order do no harm") {
    // A fixed sequence of 4,000 keys and mouse reports, from a small generator.
    Person person;
    std::uint32_t state = 12345;
    const auto next = [&state](std::uint32_t count) {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) % count;
    };
    const char32_t specials[] = {key::up,  key::down,   key::left,    key::right,
                                 key::tab, key::enter,  key::backtab, key::remove,
                                 key::f1,  key::escape, U' ',         U','};
    const InputEvent::Action actions[] = {InputEvent::Action::press, InputEvent::Action::move,
                                          InputEvent::Action::release, InputEvent::Action::wheel_up,
                                          InputEvent::Action::wheel_down};
    for (int i = 0; i < 4000; ++i) {
        switch (next(4)) {
            case 0:
                person.key(U'!' + next(94));
                break;
            case 1:
                person.key(specials[next(12)], next(2) ? shift : no_modifier);
                break;
            case 2: {
                const Vec2 at{static_cast<double>(next(50)) - 5.0,
                              static_cast<double>(next(40)) - 5.0};
                person.mouse(actions[next(5)], at, static_cast<std::uint8_t>(next(4)),
                             static_cast<std::uint8_t>(next(8)));
                break;
            }
            default:
                person.player.advance(0.01, [] { return false; });
        }
        if (i % 16 == 0) person.look();
        if (i % 500 == 499)
            person.window =
                Canvas(20 + static_cast<int>(next(100)), 8 + static_cast<int>(next(40)));
    }
    for (const Vec2 position : person.world().balls().position)
        CHECK(std::isfinite(position.x + position.y));
}

TEST_CASE("in a watched recording, keys control time and view but not the world") {
    Person person;
    Session session(busy_box(), {.kind = SolverKind::swept});
    session.follow({{30, command::Strike{BallId{4}, {55.0, 13.0}}},
                    {40, command::HoldBall{BallId{2}, {20.0, 12.0}}}},
                   240);
    person.player = Player(std::move(session), ascii_view(), KeyMap());
    CHECK(person.sees("recording"));
    const Session& watched = person.player.session();
    for (const char32_t key : std::u32string(U"aexEugGsk"))
        person.key(key);
    CHECK(person.sees("This is a recording: you can only watch."));
    person.mouse(InputEvent::Action::press, watched.world().balls().position[0]);
    person.mouse(InputEvent::Action::move, {30.0, 20.0});
    person.mouse(InputEvent::Action::release, {30.0, 20.0});
    person.player.advance(0.5, always);
    CHECK(watched.world().tick() == 60);
    CHECK(watched.commands().size() == 2);
    CHECK(watched.world().held_balls().size() == 1);  // by the recording
    CHECK_FALSE(watched.fault());
    person.key(U',');
    CHECK(watched.world().tick() == 59);
    person.key(U'>');
    CHECK(watched.world().tick() == 179);
    person.key(U'>');
    CHECK(watched.world().tick() == 240);
    CHECK(person.sees("recording ends here"));
    person.key(U'.');
    CHECK(watched.world().tick() == 240);
    person.key(U'n');
    person.player.advance(0.1, always);
    CHECK_FALSE(person.player.clock().is_seeking());
    person.key(U'r');
    CHECK(watched.world().tick() == 0);
    CHECK(watched.commands().size() == 2);
    person.key(U' ');
    person.player.advance(10.0, always);
    CHECK(watched.world().tick() == 240);
    CHECK(person.player.clock().is_paused());
}

TEST_CASE("a split window shows one solver after another, and finally the game alone") {
    Person person;
    person.key(U'S');
    CHECK(person.sees("|  event  tick 0"));
    CHECK(person.sees("identical since t=0.000"));
    CHECK(person.sees("event: exact impacts, one after another"));
    person.key(U'i');
    CHECK(person.sees("beside  event: exact impacts"));
    person.key(U'i');
    person.pass(0.25);
    CHECK(person.sees(" swept  tick 30"));
    CHECK(person.sees("|  event  tick 30"));
    person.key(U'S');
    CHECK(person.sees("|  contact  tick 30"));
    person.key(U'S');
    CHECK(person.sees("|  substep 4x15  tick 30"));
    person.key(U'S');
    CHECK(person.sees("|  discrete  tick 30"));
    person.key(U'S');
    CHECK_FALSE(person.sees("tick 30 "));
    CHECK(person.sees("Split view off."));
}

TEST_CASE("a divergence is marked in both halves, announced, and cleared by going back") {
    Person person;
    for (int i = 0; i < 4; ++i)
        person.key(U'S');
    REQUIRE(person.sees("|  discrete"));
    person.pass(2.0);
    const std::string text = person.look();
    CHECK(text.find("diverged at t=") != std::string::npos);
    const std::size_t mark = text.find(">X<");
    REQUIRE(mark != std::string::npos);
    CHECK(text.find(">X<", mark + 1) != std::string::npos);
    person.key(U'r');
    CHECK(person.sees("identical since t=0.000"));
    CHECK_FALSE(person.sees(">X<"));
}

TEST_CASE("in a split window, single steps miss no divergence") {
    Person stepping;
    Person running;
    for (Person* person : {&stepping, &running})
        for (int i = 0; i < 4; ++i)
            person->key(U'S');
    running.pass(1.0);
    for (int i = 0; i < 120; ++i)
        stepping.key(U'.');
    const auto divergence = [](Person& person) {
        const std::string text = person.look();
        const std::size_t at = text.find("diverged at");
        return at == std::string::npos ? std::string() : text.substr(at, 24);
    };
    CHECK_FALSE(divergence(running).empty());
    CHECK(divergence(stepping) == divergence(running));
}

TEST_CASE("in a split window, the mouse grabs the same ball in either half") {
    Person person;
    person.key(U' ');
    person.key(U'S');
    person.look();
    const CellPoint left = to_cells(person.player.camera(), person.ball(4));
    CellPoint right = left;
    right.column += 40;
    person.mouse_in_cells(InputEvent::Action::press, right, 1, no_modifier);
    CHECK(person.player.pointer().tool.has_ball());
}

TEST_CASE("the butterfly shows how far its copies are apart") {
    Person person;
    person.key(U'b');
    CHECK(person.sees("200 copies, spread 8"));
    person.pass(0.5);
    CHECK(person.sees("200 copies, spread"));
    person.key(U'S');
    CHECK(person.sees("identical since"));
    person.key(U'b');
    CHECK(person.sees("200 copies"));
    person.key(U'b');
    CHECK_FALSE(person.sees("200 copies"));
}

TEST_CASE("there is no butterfly if 200 copies do not fit into memory") {
    Scene scene = busy_box();
    for (Vec2 place{100.0, 0.0}; place.x < 60100.0; place.x += 1.0)
        add_ball(scene.world, carom::test::ball_at_rest(place));
    Player player(Session(scene, {.kind = SolverKind::swept}), ascii_view(), KeyMap());
    Canvas window(80, 24);
    player.perform(action("butterfly"));
    player.draw(window, 2.0);
    CHECK(window.text().find("Too many balls for 200 copies") != std::string::npos);
    CHECK(window.text().find("200 copies, radii") == std::string::npos);
}

TEST_CASE("a page explains which solver is in force") {
    Person person;
    person.key(U'i');
    CHECK(person.sees("solver  swept substeps=1 (chosen by you)"));
    CHECK(person.sees("auto    would choose "));
    person.key(U'i');
    CHECK_FALSE(person.sees("chosen by you"));
}

TEST_CASE("a key cancels a long tick, mouse motion does not") {
    const KeyMap keys;
    InputEvent event;
    event.key = U'q';
    CHECK(cancels_tick(event, keys));
    event.key = U'@';  // has no action
    CHECK_FALSE(cancels_tick(event, keys));
    event.key = U'q';
    event.action = InputEvent::Action::release;
    CHECK_FALSE(cancels_tick(event, keys));
    event.kind = InputEvent::Kind::mouse;
    event.action = InputEvent::Action::move;
    CHECK_FALSE(cancels_tick(event, keys));
    event.action = InputEvent::Action::press;
    CHECK(cancels_tick(event, keys));
    event.kind = InputEvent::Kind::hangup;
    CHECK(cancels_tick(event, keys));
}

TEST_CASE("the broad-phase overlay shows the cells that the solver used") {
    Person person;
    person.window = Canvas(160, 60);
    const auto picture = [&] {
        person.pass(10.0);  // the messages fade; the game is paused
        const std::string text = person.look();
        return text.substr(0, text.find("Busy box"));
    };
    person.key(U' ');
    const std::string before = picture();
    person.key(U'3');
    CHECK(person.sees("No cells: the solver has none, or has not begun."));
    CHECK(picture() == before);  // nothing has been computed yet
    person.key(U'.');
    CHECK_FALSE(person.player.session().cells() == CellFrame{});
    const std::string with_cells = picture();
    person.key(U'3');
    CHECK(with_cells != picture());
}
