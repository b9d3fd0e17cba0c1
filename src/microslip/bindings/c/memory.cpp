// SPDX-License-Identifier: MIT
#include "microslip/bindings/c/errors.hpp"
#include "microslip/bindings/c/handles.hpp"

namespace c = microslip::c;

microslip_status microslip_memory_create(const microslip_joint* joint, microslip_memory** memory) {
  return c::done([&] {
    const auto& file = c::at(joint, "joint").file;
    c::require_pointer(memory, "memory");
    *memory = new microslip_memory{file, microslip::Memory(file->joint)};
  });
}

microslip_status microslip_memory_copy(const microslip_memory* memory, microslip_memory** copy) {
  return c::done([&] {
    const microslip_memory& from = c::at(memory, "memory");
    c::require_pointer(copy, "copy");
    *copy = new microslip_memory(from);
  });
}

microslip_status microslip_memory_assign(microslip_memory* memory, const microslip_memory* from) {
  return c::done([&] { c::at(memory, "memory") = c::at(from, "from"); });
}

void microslip_memory_destroy(microslip_memory* memory) { delete memory; }

microslip_status microslip_memory_trial(const microslip_memory* memory, double displacement,
                                        double* force, double* tangent) {
  return c::done([&] {
    c::require_pointer(force, "force");
    const microslip::Memory::Response there =
        c::at(memory, "memory").memory.trial(c::finite(displacement, "displacement"));
    *force = there.force;
    if (tangent != nullptr) *tangent = there.tangent;
  });
}

microslip_status microslip_memory_advance(microslip_memory* memory, double displacement,
                                          double* force) {
  return c::done([&] {
    const double there =
        c::at(memory, "memory").memory.advance(c::finite(displacement, "displacement"));
    if (force != nullptr) *force = there;
  });
}

microslip_status microslip_memory_march(microslip_memory* memory, std::size_t count,
                                        const double* displacement, double* force) {
  return c::done([&] {
    c::require_pointer(memory, "memory");
    const std::span<double> forces = c::room(count, force, "force");
    memory->memory.march(c::values(count, displacement, "displacement"), forces);
  });
}

microslip_status microslip_memory_dissipation(const microslip_memory* memory, double displacement,
                                              double* energy) {
  return c::done([&] {
    c::at(energy, "energy") =
        c::at(memory, "memory").memory.dissipation(c::finite(displacement, "displacement"));
  });
}

microslip_status microslip_memory_stored_energy(const microslip_memory* memory, double* energy) {
  return c::done([&] { c::at(energy, "energy") = c::at(memory, "memory").memory.stored_energy(); });
}

microslip_status microslip_memory_state(const microslip_memory* memory, double* displacement,
                                        double* force) {
  return c::done([&] {
    const microslip::Memory& state = c::at(memory, "memory").memory;
    if (displacement != nullptr) *displacement = state.displacement();
    if (force != nullptr) *force = state.force();
  });
}

microslip_status microslip_memory_reset(microslip_memory* memory) {
  return c::done([&] { c::at(memory, "memory").memory.reset(); });
}
