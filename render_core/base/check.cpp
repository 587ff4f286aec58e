#include "render_core/base/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace tedavis::base {
namespace {

void print_and_abort(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: broken invariant: %s\n", file, line, condition);
    std::abort();
}

FatalStop installed = print_and_abort;

}  // namespace

void set_fatal_stop(FatalStop stop) noexcept { installed = stop != nullptr ? stop : print_and_abort; }

void fatal_stop(const char* condition, const char* file, int line) noexcept {
    installed(condition, file, line);
    std::abort();
}

}  // namespace tedavis::base
