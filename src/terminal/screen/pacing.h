#pragma once

#include <cstddef>
#include <deque>

/// When to draw the next frame, so that a slow link never queues up old ones.
///
/// Every frame ends with a question (Screen::show with FrameEnd::asks), and only a few frames may
/// be unanswered at a time: two, more where the way is long but not crowded. Pure arithmetic on
/// times that the caller measures, in seconds on any clock that does not go back:
///
///     if (pacing.may_draw(now, input_came)) {
///         bytes = screen.show(canvas, FrameEnd::asks);
///         if (bytes > 0) pacing.drawn(now, bytes);
///     }
///     events = screen.wait(pacing.seconds_to_frame(now));
///     pacing.answered(screen.frames_answered(), now = clock());
namespace carom {

struct PacingOptions {
    double frames_per_second = 60.0;  ///< most frames, > 0
    double bytes_per_second = 0.0;    ///< most bytes on average; 0: no limit

    friend bool operator==(const PacingOptions&, const PacingOptions&) = default;
};

/// For links that cannot be measured from here (tmux and mosh answer by themselves).
inline constexpr PacingOptions low_bandwidth_pacing{.frames_per_second = 15.0,
                                                    .bytes_per_second = 4000.0};

class Pacing {
  public:
    explicit Pacing(const PacingOptions& options = {});

    /// Whether a frame may go out now. `urgent`: something came in that the person wants to see the
    /// effect of; it need not wait for the regular instant, only for the link.
    bool may_draw(double now, bool urgent = false) const;
    /// A frame of so many bytes went out, and asked.
    void drawn(double now, std::size_t bytes);
    /// So many frames have been answered in all since the start.
    void answered(std::size_t total, double now);

    /// How long to wait for input until a frame, or an urgent one, may be due; 0 if it is due. An
    /// answer, which ends the wait, may make it due earlier.
    double seconds_to_frame(double now, bool urgent = false) const;

    /// The terminal used to answer and has not for 2 s: the game should stand still. A frame may go
    /// out every 2 s (every quarter of a second when something comes in), to ask again; make sure
    /// that it is not empty (Screen::redraw).
    bool is_stalled(double now) const;
    /// It has never answered, for half a second or more: frames come at a fixed, modest rate.
    bool is_blind(double now) const;

    std::size_t unanswered() const { return sent_.size(); }
    std::size_t window() const {
        return is_probing_ ? 1 : window_;
    }                                                  ///< most unanswered frames at present
    double round_trip() const { return round_trip_; }  ///< of the last answered frame, s

  private:
    struct Sent {
        double at = 0.0;
        bool was_alone = false;  // nothing else was on its way
    };
    double interval(double now) const;
    void learn(const Sent& frame, double now);

    PacingOptions options_;
    std::deque<Sent> sent_;         // the unanswered frames, oldest first
    std::size_t drawn_ = 0;         // frames ever
    std::size_t lost_ = 0;          // answers that are no longer expected
    bool has_answers_ = false;      // ever
    bool has_asked_again_ = false;  // stalled, and a frame went out since
    std::size_t window_ = 2;
    std::size_t changed_at_ =
        0;  // number of the last frame that does not show what the last change did
    double may_grow_at_ = -1.0e9;
    bool is_probing_ = false;  // one frame at a time, to see how short the way is now
    double round_trip_ = 0.0;
    double shortest_trip_ = 0.0;  // the way without a queue; 0: not known
    double seen_short_ = 0.0;     // when a trip was last about as short as that
    double last_drawn_ = -1.0e9;
    double next_due_ = -1.0e9;
    double bytes_due_ = -1.0e9;  // when the link is through with what was sent, by the limit
};

}  // namespace carom
