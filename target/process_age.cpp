#include "target/process_age.hpp"

#include <fcntl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>

namespace tedavis::target {
namespace {

constexpr std::int64_t kTickBase_ns = 1'000'000'000;

}  // namespace

/// The program's own name, in brackets, may hold blanks and brackets: fields are counted behind its last bracket.
std::uint64_t start_ticks(std::string_view stat) {
    constexpr int kBlanksBefore = 20;  // the start is field 22, and field 3 follows the bracket
    const std::size_t bracket = stat.rfind(')');
    if (bracket == std::string_view::npos) return 0;
    std::string_view rest = stat.substr(bracket + 1);
    for (int n = 0; n < kBlanksBefore; ++n) {
        const std::size_t blank = rest.find(' ');
        if (blank == std::string_view::npos) return 0;
        rest.remove_prefix(blank + 1);
    }
    std::uint64_t ticks = 0;
    return std::from_chars(rest.data(), rest.data() + rest.size(), ticks).ec == std::errc() ? ticks : 0;
}

base::Duration process_age() {
    char text[1024];
    const int file = ::open("/proc/self/stat", O_RDONLY | O_CLOEXEC);
    if (file < 0) return {};
    const ssize_t size = ::read(file, text, sizeof text);
    ::close(file);
    const long per_second = ::sysconf(_SC_CLK_TCK);
    timespec now{};
    if (size <= 0 || per_second <= 0 || ::clock_gettime(CLOCK_BOOTTIME, &now) != 0) return {};
    const auto ticks = static_cast<std::int64_t>(start_ticks({text, static_cast<std::size_t>(size)}));
    const std::int64_t since_boot = static_cast<std::int64_t>(now.tv_sec) * kTickBase_ns + now.tv_nsec;
    return ticks == 0 ? base::Duration{}
                      : base::Duration{std::max<std::int64_t>(0, since_boot - ticks * (kTickBase_ns / per_second))};
}

}  // namespace tedavis::target
