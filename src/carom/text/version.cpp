#include "carom/text/version.h"

namespace carom {

std::string_view version() {
    return CAROM_VERSION;
}

}  // namespace carom
