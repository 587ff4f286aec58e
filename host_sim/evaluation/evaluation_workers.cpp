#include "host_sim/evaluation/evaluation_workers.hpp"

#include "host_sim/user_error.hpp"
#include "platform/threads/thread_workers.hpp"

namespace tedavis::host_sim {

std::unique_ptr<base::Workers> evaluation_workers(std::uint32_t threads) {
    auto workers = platform::make_thread_workers({threads == 0 ? platform::usable_processors() : threads, nullptr});
    if (!workers.ok()) throw UserError(std::string(workers.error().message.view()));
    return std::move(workers.value());
}

}  // namespace tedavis::host_sim
