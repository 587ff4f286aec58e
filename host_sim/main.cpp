// Composition root of the desk simulator.
#include <unistd.h>

#include <iostream>

#include "host_sim/answer_input.hpp"
#include "host_sim/commands/command_line.hpp"

int main(int argc, char** argv) {
    std::ios::sync_with_stdio(false);
    const bool is_live = isatty(STDERR_FILENO) != 0;
    tedavis::host_sim::AnswerInput typed(STDIN_FILENO);
    std::istream answers(&typed);
    const bool is_answered = is_live && isatty(STDIN_FILENO) != 0;
    return tedavis::host_sim::run_command_line(argc, argv, std::cout, std::cerr, is_live, is_answered ? &answers : nullptr);
}
