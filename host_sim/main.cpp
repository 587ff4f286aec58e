// Composition root of the desk simulator.
#include <unistd.h>

#include <iostream>

#include "host_sim/answer_input.hpp"
#include "host_sim/commands/command_line.hpp"
#include "render_core/base/float_environment.hpp"

int main(int argc, char** argv) {
    tedavis::base::set_float_environment();
    if (const auto fault = tedavis::base::float_fault(); fault != tedavis::base::FloatFault::none) {
        std::cerr << "tedavis: numbers are not computed as they must be (" << tedavis::base::words_of(fault)
                  << "); build the program anew without options that change arithmetic, or take another machine\n";
        return 1;
    }
    std::ios::sync_with_stdio(false);
    const bool is_live = isatty(STDERR_FILENO) != 0;
    tedavis::host_sim::AnswerInput typed(STDIN_FILENO);
    std::istream answers(&typed);
    const bool is_answered = is_live && isatty(STDIN_FILENO) != 0;
    return tedavis::host_sim::run_command_line(argc, argv, std::cout, std::cerr, is_live, is_answered ? &answers : nullptr);
}
