#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace autostereo::test {

/// Pulls and plugs the simulated OpenNI2 camera of this process. The library has to have loaded it.
class SimulatedPlug {
  public:
    SimulatedPlug() {
        const char* folder = std::getenv("LD_LIBRARY_PATH");
        if (folder == nullptr) throw std::runtime_error("LD_LIBRARY_PATH: not set (run by ctest)");
        const std::string file = std::string(folder) + "/OpenNI2/Drivers/libautostereo_sim.so.0";
        driver_ = dlopen(file.c_str(), RTLD_NOW | RTLD_NOLOAD);
        if (driver_ == nullptr) throw std::runtime_error(file + " is not loaded");
    }
    SimulatedPlug(const SimulatedPlug&) = delete;
    SimulatedPlug& operator=(const SimulatedPlug&) = delete;
    ~SimulatedPlug() { dlclose(driver_); }

    void pull() const { call("autostereoSimulatedUnplug"); }
    void plug() const { call("autostereoSimulatedPlug"); }

  private:
    void call(const char* name) const { reinterpret_cast<void (*)()>(dlsym(driver_, name))(); }
    void* driver_;
};

} // namespace autostereo::test
