#include "terminal/screen/pacing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <deque>
#include <vector>

using namespace carom;

namespace {

/// A terminal at the end of a link: frames queue up, take their time on the link, and are answered
/// when they have arrived.
struct Link {
    double delay = 0.0;  // s, one way
    double bytes_per_second = 1e9;
    bool answers = true;

    double sent_at = -1.0;           // the last time that something was sent
    double free_at = 0.0;            // when the link has sent everything queued
    std::deque<double> answers_due;  // when answers reach the game
    std::vector<double> ages;        // of each frame when it is shown, s
    std::size_t answered = 0;

    // What is sent at one time arrives at one time, as in a packet of SSH.
    void carry(double now, double bytes) {
        free_at = std::max(free_at, now) + bytes / bytes_per_second;
        if (answers) answers_due.push_back(free_at + 2 * delay);
        if (answers && now == sent_at && answers_due.size() > 1)
            answers_due[answers_due.size() - 2] = answers_due.back();
        sent_at = now;
    }
    void send(double now, double bytes) {
        carry(now, bytes);
        ages.push_back(free_at + delay - now);
    }
    std::size_t take(double now) {
        while (!answers_due.empty() && answers_due.front() <= now) {
            answers_due.pop_front();
            ++answered;
        }
        return answered;
    }
    double worst_age_after(std::size_t first) const {
        double worst = 0.0;
        for (std::size_t i = first; i < ages.size(); ++i) {
            worst = std::max(worst, ages[i]);
        }
        return worst;
    }
};

// Simulates for so long and returns the number of frames; time advances in steps of a millisecond.
int play(Pacing& pacing, Link& link, double& now, double seconds, double bytes,
         bool is_urgent = false) {
    int frames = 0;
    for (const double end = now + seconds; now < end; now += 0.001) {
        pacing.answered(link.take(now), now);
        if (pacing.wants_query()) {
            link.carry(now, 4);
            pacing.asked(now);
        }
        if (!pacing.may_draw(now, is_urgent)) continue;
        link.send(now, bytes);
        pacing.drawn(now, static_cast<std::size_t>(bytes));
        ++frames;
    }
    return frames;
}

}  // namespace

TEST_CASE("a terminal nearby gets every frame, in time") {
    Pacing pacing;
    Link link{.delay = 0.0005};
    double now = 100.0;
    CHECK(play(pacing, link, now, 10.0, 1000) == doctest::Approx(600).epsilon(0.01));
    CHECK(link.worst_age_after(0) < 0.002);
    CHECK_FALSE(pacing.is_stalled(now));
    CHECK_FALSE(pacing.is_blind(now));
}

TEST_CASE("the frame rate is the requested one") {
    for (const double wanted : {1.0, 10.0, 30.0, 60.0, 120.0}) {
        Pacing pacing({.frames_per_second = wanted});
        Link link{.delay = 0.001};
        double now = 0.0;
        CHECK(play(pacing, link, now, 20.0, 100) == doctest::Approx(20.0 * wanted).epsilon(0.06));
    }
}

TEST_CASE("a distant terminal on a fast link gets nearly every frame too") {
    for (const double delay : {0.05, 0.1, 0.2}) {
        CAPTURE(delay);
        Pacing pacing;
        Link link{.delay = delay, .bytes_per_second = 1e6};
        double now = 0.0;
        play(pacing, link, now, 5.0, 1000);
        CHECK(play(pacing, link, now, 10.0, 1000) >= 590);
        CHECK(link.worst_age_after(0) < delay + 0.01);
    }
}

TEST_CASE("on a congested link no frame is old") {
    for (const double delay : {0.001, 0.02, 0.1}) {
        for (const double rate : {10e3, 30e3, 55e3}) {
            CAPTURE(delay);
            CAPTURE(rate);
            Pacing pacing;
            Link link{.delay = delay, .bytes_per_second = rate};
            double now = 0.0;
            const double bytes = 1000;
            const int frames = play(pacing, link, now, 20.0, bytes);
            const double on_the_line = bytes / rate;
            // Its own time on the link, that of the frame before it, and a little.
            CHECK(link.worst_age_after(0) < delay + 2.0 * on_the_line + 0.05);
            // The link is used well.
            const double trip = 2.0 * delay + on_the_line;
            const double possible = std::min({rate / bytes, 2.0 / trip, 60.0});
            CHECK(frames > 0.8 * 20.0 * possible);
        }
    }
}

TEST_CASE(
    "frames that fill a near link go one at a time, and none is older than it takes to send") {
    for (const double delay : {0.0002, 0.002, 0.008}) {
        CAPTURE(delay);
        Pacing pacing;
        Link link{.delay = delay, .bytes_per_second = 64e3};
        double now = 0.0;
        const double bytes = 7680;
        const double on_the_line = bytes / link.bytes_per_second;
        play(pacing, link, now, 1.0, bytes);
        const std::size_t settled = link.ages.size();
        const int frames = play(pacing, link, now, 60.0, bytes);
        CHECK(link.worst_age_after(settled) < delay + on_the_line + 0.005);
        CHECK(frames > 0.8 * 60.0 / on_the_line);
        // Small frames flow at the full rate again.
        play(pacing, link, now, 10.0, 200);
        CHECK(play(pacing, link, now, 10.0, 200) > 590);
    }
}

TEST_CASE("the round trip is measured without the time that frames take") {
    Pacing pacing;
    Link link{.delay = 0.08, .bytes_per_second = 64e3};
    double now = 0.0;
    play(pacing, link, now, 5.0, 7680);
    // A frame takes 0.12 s: alone it would leave the link idle for more than half of the time.
    CHECK(pacing.window() == 2);
    CHECK(play(pacing, link, now, 60.0, 7680) > 0.95 * 60.0 * 2.0 / (0.12 + 0.16));
}

TEST_CASE("a link that becomes slow, and fast again, is noticed") {
    Pacing pacing;
    Link link{.delay = 0.1, .bytes_per_second = 1e6};
    double now = 0.0;
    play(pacing, link, now, 10.0, 1000);
    CHECK(pacing.window() > 6);
    link.bytes_per_second = 20e3;
    play(pacing, link, now, 3.0, 1000);
    const std::size_t settled = link.ages.size();
    play(pacing, link, now, 20.0, 1000);
    CHECK(link.worst_age_after(settled) < 0.1 + 2 * 0.05 + 0.05);
    link.bytes_per_second = 1e6;
    play(pacing, link, now, 10.0, 1000);
    CHECK(play(pacing, link, now, 10.0, 1000) > 590);
}

TEST_CASE("the response to input is shown at once") {
    Pacing pacing;
    pacing.drawn(10.0, 100);
    pacing.answered(1, 10.001);
    CHECK_FALSE(pacing.may_draw(10.005));
    CHECK(pacing.may_draw(10.005, true));
    CHECK_FALSE(pacing.may_draw(10.002, true));  // but not a thousand times a second
}

TEST_CASE("urgent frames respect the link") {
    Pacing pacing;
    Link link{.delay = 0.05, .bytes_per_second = 20e3};
    double now = 0.0;
    play(pacing, link, now, 10.0, 1000, true);
    CHECK(link.worst_age_after(0) < 0.05 + 2 * 0.05 + 0.05);
}

TEST_CASE("a terminal that never answers gets frames at a modest rate") {
    Pacing pacing;
    Link link{.answers = false};
    double now = 0.0;
    CHECK_FALSE(pacing.is_blind(now));
    play(pacing, link, now, 1.0, 100);
    CHECK(pacing.is_blind(now));
    CHECK_FALSE(pacing.is_stalled(now));
    CHECK(play(pacing, link, now, 10.0, 100) == doctest::Approx(200).epsilon(0.05));
    CHECK(pacing.unanswered() <= 256);
}

TEST_CASE("a late first answer ends the modest rate") {
    Pacing pacing;
    Link link{.delay = 0.4};
    double now = 0.0;
    play(pacing, link, now, 15.0, 100);
    CHECK_FALSE(pacing.is_blind(now));
    CHECK(play(pacing, link, now, 10.0, 100) > 590);
}

TEST_CASE("after two seconds without an answer everything stops, and continues with the answers") {
    Pacing pacing;
    Link link{.delay = 0.01};
    double now = 0.0;
    play(pacing, link, now, 2.0, 100);
    link.answers = false;
    play(pacing, link, now, 1.9, 100);
    CHECK_FALSE(pacing.is_stalled(now));
    play(pacing, link, now, 0.3, 100);
    CHECK(pacing.is_stalled(now));
    CHECK(play(pacing, link, now, 20.0, 100) <= 11);  // it queries now and then
    CHECK(pacing.is_stalled(now) == (pacing.unanswered() > 0 && pacing.seconds_to_frame(now) < 2));
    link.answers = true;
    play(pacing, link, now, 3.0, 100);
    CHECK_FALSE(pacing.is_stalled(now));
    CHECK(play(pacing, link, now, 10.0, 100) > 580);
}

TEST_CASE("lost answers do not slow it down for ever") {
    Pacing pacing;
    Link link{.delay = 0.01};
    double now = 0.0;
    play(pacing, link, now, 2.0, 100);
    link.answers = false;
    play(pacing, link, now, 0.1, 100);  // the two on their way are lost
    link.answers = true;
    play(pacing, link, now, 5.0, 100);
    CHECK(play(pacing, link, now, 10.0, 100) > 580);
}

TEST_CASE("a limit of bytes a second is kept") {
    Pacing pacing(low_bandwidth_pacing);
    Link link{.delay = 0.001};
    double now = 0.0;
    CHECK(play(pacing, link, now, 10.0, 1000) == doctest::Approx(40).epsilon(0.05));
    CHECK(play(pacing, link, now, 10.0, 100) == doctest::Approx(150).epsilon(0.05));
}

TEST_CASE("the wait for a frame ends when it is due") {
    Pacing pacing;
    pacing.drawn(1.0, 100);
    pacing.answered(1, 1.001);
    CHECK(pacing.seconds_to_frame(1.001) == doctest::Approx(1.0 / 60.0 - 0.001));
    CHECK(pacing.seconds_to_frame(1.1) == 0.0);
    pacing.drawn(1.1, 100);
    pacing.drawn(1.12, 100);
    CHECK_FALSE(pacing.may_draw(1.2));  // two are unanswered
    CHECK(pacing.seconds_to_frame(1.2) > 0.5);
}

TEST_CASE("the response to a key waits for the last frame only, not for the regular time") {
    Pacing pacing;
    pacing.answered(0, 1.0);
    pacing.drawn(1.0, 100);
    pacing.answered(1, 1.001);
    CHECK(pacing.seconds_to_frame(1.001) == doctest::Approx(1.0 / 60 - 0.001));
    const double urgent = pacing.seconds_to_frame(1.001, true);
    CHECK(urgent < 0.004);
    CHECK_FALSE(pacing.may_draw(1.001, true));
    CHECK(pacing.may_draw(1.001 + urgent + 1e-6, true));
    CHECK_FALSE(pacing.may_draw(1.001 + urgent + 1e-6));
}
