#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "level/text/text.h"
#include "physics/world/bodies.h"

namespace carom {

/// The source of an item: its place in the file, and which mirror image it is. A level may have a
/// million of them, so the span is packed.
class Origin {
  public:
    Origin() = default;
    /// Pre: the span lies within a line, which has at most 4,096 bytes.
    explicit Origin(const Span& span, int of_image = 0)
        : image(of_image),
          line_(span.line),
          source_(span.source),
          column_(static_cast<std::uint16_t>(span.column)),
          length_(static_cast<std::uint16_t>(span.length)) {}

    Span span() const { return {source_, line_, column_, length_}; }

    int image = 0;  ///< a number for each image of each mirror; 0: the original

  private:
    int line_ = 1;
    const SourceText* source_ = nullptr;
    std::uint16_t column_ = 1;
    std::uint16_t length_ = 1;
};

/// The IR of a ball. The kind of the spec is not yet known: it is that of the binding.
struct BallIr : BallSpec {
    /// In a rack: the offset from `position`, in units of a diameter plus the gap.
    Vec2 racked;
    double gap = 0.0;
    int binding = 0;  ///< index into LevelIr::ball_bindings
    int device = -1;  ///< of a captive ball: index into LevelIr::devices
    Origin origin;
};

/// Balls in the order of the file, 48 bytes each. A BallIr is four times as large, but most balls
/// differ from an earlier one of their statement in their position and origin alone; they share
/// the rest.
class BallList {
  public:
    std::size_t size() const { return records_.size(); }
    bool empty() const { return records_.empty(); }
    BallIr operator[](std::size_t i) const;
    Vec2 position(std::size_t i) const { return records_[i].position; }
    /// The ball but for its position and origin, valid until the list changes.
    const BallIr& shared_part(std::size_t i) const { return shared_[records_[i].shared]; }

    /// Returns whether it takes memory for more than a record: it shares nothing.
    bool push_back(const BallIr& ball);
    /// Pre: as long as the list.
    void remove(const std::vector<bool>& is_removed);

  private:
    struct Record {
        Vec2 position;
        Origin origin;
        std::uint32_t shared = 0;  // index into shared_
    };
    std::deque<Record> records_;              // a vector that grows needs memory for both copies
    std::vector<BallIr> shared_;              // but for position and origin
    std::vector<std::uint32_t> last_shared_;  // by binding: the last of its balls
};

}  // namespace carom
