// Composition root of the desk simulator.
#include <unistd.h>

#include <iostream>

#include "host_sim/commands/command_line.hpp"

int main(int argc, char** argv) {
    std::ios::sync_with_stdio(false);
    return tedavis::host_sim::run_command_line(argc, argv, std::cout, std::cerr, isatty(STDERR_FILENO) != 0);
}
