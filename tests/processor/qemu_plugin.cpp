// SPDX-License-Identifier: Apache-2.0
// Loaded into QEMU: writes a QemuRecord to the standard output before each instruction. QEMU's own
// log of the same (`-d cpu`) is text, which takes longer to write and to read.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "tests/processor/qemu_plugin_api.hpp"
#include "tests/processor/qemu_record.hpp"

namespace {

using processor::QemuRecord;

constexpr std::uint32_t first_address = 0x80000000;  // below it runs QEMU's loader
constexpr const char* integer_names[] = {"zero", "ra", "sp",  "gp",  "tp", "t0", "t1", "t2",
                                         "fp",   "s1", "a0",  "a1",  "a2", "a3", "a4", "a5",
                                         "a6",   "a7", "s2",  "s3",  "s4", "s5", "s6", "s7",
                                         "s8",   "s9", "s10", "s11", "t3", "t4", "t5", "t6"};

struct Handles {
  qemu_plugin_register* integers[32];
  qemu_plugin_register* mtvec;
  qemu_plugin_register* mepc;
};

Handles handles{};
GByteArray* bytes;
QemuRecord record;
std::uint32_t next_address;

std::uint32_t value_of(qemu_plugin_register* handle) {
  g_byte_array_set_size(bytes, 0);
  if (qemu_plugin_read_register(handle, bytes) != 4) std::abort();
  std::uint32_t value;
  std::memcpy(&value, bytes->data, sizeof value);
  return value;
}

void note(unsigned, void* data) {
  const auto packed = reinterpret_cast<std::uintptr_t>(data);
  const auto address = static_cast<std::uint32_t>(packed);
  record.program_counter = address;
  if (address != next_address) {
    record.mtvec = value_of(handles.mtvec);
    record.mepc = value_of(handles.mepc);
  }
  next_address = address + static_cast<std::uint32_t>(packed >> 32);
  for (unsigned i = 1; i < 32; ++i) record.registers[i] = value_of(handles.integers[i]);
  if (std::fwrite(&record, sizeof record, 1, stdout) != 1) {
    std::_Exit(0);  // the test has ended
  }
}

qemu_plugin_register* handle_of(const GArray& descriptors, const std::string& name) {
  const auto* const all = reinterpret_cast<const qemu_plugin_reg_descriptor*>(descriptors.data);
  for (unsigned i = 0; i < descriptors.len; ++i) {
    if (all[i].name == name) return all[i].handle;
  }
  std::fprintf(stderr, "QEMU gives the plugin no register %s\n", name.c_str());
  std::exit(1);
}

void find_registers(qemu_plugin_id_t, unsigned) {
  GArray* const descriptors = qemu_plugin_get_registers();
  for (unsigned i = 0; i < 32; ++i) handles.integers[i] = handle_of(*descriptors, integer_names[i]);
  handles.mtvec = handle_of(*descriptors, "mtvec");
  handles.mepc = handle_of(*descriptors, "mepc");
  g_array_free(descriptors, 1);
  bytes = g_byte_array_new();
}

void add_notes(qemu_plugin_id_t, qemu_plugin_tb* block) {
  const std::size_t count = qemu_plugin_tb_n_insns(block);
  for (std::size_t i = 0; i < count; ++i) {
    qemu_plugin_insn* const instruction = qemu_plugin_tb_get_insn(block, i);
    const std::uint64_t address = qemu_plugin_insn_vaddr(instruction) & 0xffffffff;
    if (address < first_address) continue;
    const std::uint64_t packed = address | std::uint64_t{qemu_plugin_insn_size(instruction)} << 32;
    qemu_plugin_register_vcpu_insn_exec_cb(instruction, note, qemu_plugin_reads_registers,
                                           reinterpret_cast<void*>(packed));
  }
}

}  // namespace

extern "C" {

[[gnu::visibility("default")]] int qemu_plugin_version = 4;

[[gnu::visibility("default")]] int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t*, int,
                                                       char**) {
  qemu_plugin_register_vcpu_init_cb(id, find_registers);
  qemu_plugin_register_vcpu_tb_trans_cb(id, add_notes);
  return 0;
}

}  // extern "C"
