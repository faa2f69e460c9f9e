#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "game/session/session.h"
#include "terminal/panels/score_panel.h"

/// What a pinball table says, one message after another, each long enough to be read. The game
/// itself knows the latest message alone (PinballState::message).
namespace carom {

class PinballMessages {
  public:
    /// Takes up what the table has said since the last look. Returns whether that has changed
    /// text(). The first look, and one at an earlier time or in another turn, take over what the
    /// game says, which is no change.
    ///
    /// What comes with many points at once, or with more balls, is large: it goes before others. A
    /// tilt, a warning, a drain, and the time between two balls interrupt, and nothing waits then.
    bool follow(const Session& session);

    /// Empty: the table says nothing.
    const std::string& text() const { return shown_.text; }
    /// Whether it is a large moment now, and which of the two colours of that has its turn.
    ScorePanel::Moment moment() const;

  private:
    struct Message {
        std::string text;
        bool is_large = false;
    };
    /// What of the game tells that something has happened.
    struct Seen {
        std::uint64_t said = 0;  ///< tick of the latest message
        std::int64_t score = 0;
        std::uint32_t player = 0;
        std::size_t balls = 0;  ///< in play, and to be served
        std::uint32_t warnings = 0;
        std::uint64_t drained = 0;
    };
    static Seen look(const Session& session);
    void start_from(const Session& session);
    void hear(const Session& session, const Seen& now, const Seen& before);
    void take(Message message);
    void show(Message message);
    void pass();
    double shown_for() const;  ///< s of simulated time

    Message shown_;
    std::uint64_t shown_since_ = 0;  ///< ticks
    std::deque<Message> waiting_;
    Seen seen_;
    bool has_looked_ = false;
    std::uint64_t tick_ = 0;
    double rate_ = 1.0;
    bool is_said_ = false;  ///< the game still says its latest message
};

}  // namespace carom
