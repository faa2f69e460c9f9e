#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "geometry/f64x2.h"
#include "physics/world/ids.h"

namespace carom {

/// Bit by bit, which takes a small part of the time of a comparison by numbers. Pre: no bytes of a
/// Value are padding.
template <typename Value>
bool have_same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

/// What an array held, to tell whether it still does: of one whose values are all the same, only
/// that value. Pre: as for `have_same_bits`.
template <typename Value>
class KeptBits {
  public:
    void keep(const std::vector<Value>& values) {
        count_ = values.size();
        are_same_ = are_all_the_same(values);
        values_.assign(values.begin(), are_same_ ? values.begin() + 1 : values.end());
    }
    bool are(const std::vector<Value>& values) const {
        if (values.size() != count_) return false;
        if (!are_same_) return have_same_bits(values, values_);
        return are_all_the_same(values) &&
               std::memcmp(values.data(), values_.data(), sizeof(Value)) == 0;
    }

  private:
    static bool are_all_the_same(const std::vector<Value>& values) {
        return !values.empty() && std::memcmp(values.data(), values.data() + 1,
                                              (values.size() - 1) * sizeof(Value)) == 0;
    }

    std::vector<Value> values_;
    std::size_t count_ = 0;
    bool are_same_ = false;
};

/// The same of numbers that ascend: of those without a gap, the first and how many.
template <typename Id>
class KeptIds {
  public:
    void keep(const std::vector<Id>& ids) {
        count_ = ids.size();
        first_ = ids.empty() ? Id{} : ids.front();
        ids_.assign(ids.begin(), are_consecutive(ids) ? ids.begin() : ids.end());
    }
    bool are(const std::vector<Id>& ids) const {
        if (ids.size() != count_) return false;
        if (!ids_.empty()) return have_same_bits(ids, ids_);
        return ids.empty() || (ids.front() == first_ && are_consecutive(ids));
    }
    std::size_t size() const { return count_; }
    Id operator[](std::size_t i) const {
        return ids_.empty() ? Id{number(first_) + static_cast<std::uint32_t>(i)} : ids_[i];
    }

  private:
    std::vector<Id> ids_;
    std::size_t count_ = 0;
    Id first_{};
};

/// Stands for an array of pairs of numbers too long to be kept: who adds the same bits in the same
/// order has the same sum, and others have it with a chance of about 2^-32. Not for those who mean
/// harm. (After NH, of Black, Halevi, Krawczyk, Krovetz and Rogaway, UMAC: fast and secure message
/// authentication, CRYPTO 1999; its keys are counted here, and stirred together with the bits.)
class SumOfBits {
  public:
    void add(TwoBits bits) {
        key_ += TwoBits{0x9fb21c651e98df25u, 0xd6e8feb86659fd93u};
        bits += key_;
        bits ^= bits >> 15;
        sum_ += low_products(bits, bits >> 32);
    }
    friend bool operator==(const SumOfBits& a, const SumOfBits& b) {
        const TwoBits differ = (a.sum_ ^ b.sum_) | (a.key_ ^ b.key_);
        return (differ[0] | differ[1]) == 0;
    }

  private:
    TwoBits key_{};  ///< tells how many were added
    TwoBits sum_{};
};

}  // namespace carom
