#pragma once

#include <cstddef>
#include <deque>

/// Decides when to draw the next frame, so that old frames never queue up on a slow link.
///
/// Every frame ends with a status query (Screen::show with FrameEnd::asks), and only a few frames
/// may be unanswered at a time:
///
///     one             while sending a frame takes many times the round trip
///     two             normally
///     more than two   where the round trip is long and the queue short
///
/// A query by itself measures the round trip without the time that it takes to send a frame: after
/// a first frame that took long, and now and then on a congested link. No frame follows it before
/// the answer, since SSH may put both into one packet. Pure arithmetic on times, in seconds of a
/// monotonic clock, that the caller measures:
///
///     if (pacing.wants_query() && screen.ask()) pacing.asked(now);
///     if (pacing.may_draw(now, input_came)) {
///         bytes = screen.show(canvas, FrameEnd::asks);
///         if (bytes > 0) pacing.drawn(now, bytes);
///     }
///     events = screen.wait(pacing.seconds_to_frame(now));
///     pacing.answered(screen.frames_answered(), now = clock());
namespace carom {

struct PacingOptions {
    double frames_per_second = 60.0;  ///< most frames, > 0
    double bytes_per_second = 0.0;    ///< average limit; 0: none

    friend bool operator==(const PacingOptions&, const PacingOptions&) = default;
};

/// For links that cannot be measured from here, because tmux or mosh answers on the near side.
inline constexpr PacingOptions low_bandwidth_pacing{.frames_per_second = 15.0,
                                                    .bytes_per_second = 4000.0};

class Pacing {
  public:
    explicit Pacing(const PacingOptions& options = {});

    /// Whether a frame may be sent now. `urgent`: there was input, whose effect the player wants to
    /// see. An urgent frame waits for the link, but not for its regular time.
    bool may_draw(double now, bool urgent = false) const;
    /// A frame of so many bytes was sent, and ended with a query.
    void drawn(double now, std::size_t bytes);
    /// Whether a query by itself should be sent now; frames wait for its answer.
    bool wants_query() const { return is_probing_ && sent_.empty(); }
    /// Such a query was sent.
    void asked(double now);
    /// The total number of answers since the start, to frames and queries.
    void answered(std::size_t total, double now);

    /// How long to wait for input before a frame (or an urgent one) may be sent, s; 0 if it may be
    /// sent now. Any answer should end the wait, since it may make a frame due earlier.
    double seconds_to_frame(double now, bool urgent = false) const;

    /// The terminal used to answer and has not done so for 2 s: the game should pause. A frame may
    /// be sent every 2 s (every 0.25 s after input) to query again; make sure that it is not empty
    /// (Screen::redraw).
    bool is_stalled(double now) const;
    /// The terminal has not answered yet, half a second after the first frame: frames are sent at a
    /// fixed, modest rate.
    bool is_blind(double now) const;

    std::size_t unanswered() const { return sent_.size(); }  ///< frames and queries
    std::size_t window() const {
        return is_probing_ ? 1 : window_;
    }                                                  ///< most unanswered frames at present
    double round_trip() const { return round_trip_; }  ///< of the last answered frame, s

  private:
    struct Sent {
        double at = 0.0;
        bool was_alone = false;  // no earlier frame was unanswered
        bool is_query = false;   // by itself, without a frame
    };
    double interval(double now) const;
    void learn(const Sent& sent, double now);

    PacingOptions options_;
    std::deque<Sent> sent_;         // what is unanswered, oldest first
    std::size_t drawn_ = 0;         // frames and queries sent since the start
    std::size_t lost_ = 0;          // answers that are no longer expected
    bool has_answers_ = false;      // at least one answer has come
    bool has_asked_again_ = false;  // stalled, and a frame has been sent since
    std::size_t window_ = 2;
    /// Number of the last frame that does not yet show the effect of the last change of window_.
    std::size_t changed_at_ = 0;
    double may_grow_at_ = -1.0e9;
    bool is_probing_ = false;  // one frame at a time, so that a query meets no queue
    double round_trip_ = 0.0;
    double shortest_trip_ = 0.0;  // the round trip without a queue; 0: not known
    double seen_short_ = 0.0;     // when a round trip was last about that short
    double last_drawn_ = -1.0e9;
    double next_due_ = -1.0e9;
    double bytes_due_ = -1.0e9;  // when the byte limit allows the next frame
};

}  // namespace carom
