namespace tedavis::host_sim {
const char* version() { return TEDAVIS_VERSION; }
}
