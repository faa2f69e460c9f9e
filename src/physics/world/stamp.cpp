#include "physics/world/stamp.h"

#include <atomic>

namespace carom {

Stamp new_stamp() {
    static std::atomic<std::uint64_t> last{0};
    return Stamp{last.fetch_add(1, std::memory_order_relaxed) + 1};
}

}  // namespace carom
