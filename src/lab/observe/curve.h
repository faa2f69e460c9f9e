#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

/// What an observation has found, for reports and panels.
namespace carom {

struct CurvePoint {
    double x = 0.0;
    double y = 0.0;
    std::optional<double> expected{};  ///< by theory, where there is one for any scene

    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// A function: y over x.
struct Curve {
    std::string_view x_name;
    std::vector<CurvePoint> points;
};

/// A number by its name in reports; none where it has no value.
struct ObservedValue {
    std::string_view name;
    std::optional<double> value;
};

/// Some hundred points of a function of time, over the whole run. When it is full, every second
/// point is dropped and the spacing doubles, so the first and the latest times are covered.
class Series {
  public:
    static constexpr std::size_t capacity = 512;

    /// Keeps the point if it is due. Pre: `tick` is above that of the last call.
    void add(std::uint64_t tick, CurvePoint point) {
        if (!points_.empty() && tick < last_tick_ + spacing_) return;
        last_tick_ = tick;
        points_.push_back(point);
        if (points_.size() < capacity) return;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < points_.size(); i += 2)
            points_[kept++] = points_[i];
        points_.resize(kept);
        spacing_ *= 2;
    }

    const std::vector<CurvePoint>& points() const { return points_; }

  private:
    std::vector<CurvePoint> points_;
    std::uint64_t last_tick_ = 0;
    std::uint64_t spacing_ = 1;
};

}  // namespace carom
