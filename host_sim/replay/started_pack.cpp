#include "host_sim/replay/started_pack.hpp"

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

std::string words_of_started(const platform::CheckedPack& pack, base::Time flight) {
    if (const base::Error error = platform::confirm_pack(pack)) throw UserError(std::string(error.message.view()));
    return std::string(platform::words_of_age(pack, flight).view());
}

}  // namespace tedavis::host_sim
