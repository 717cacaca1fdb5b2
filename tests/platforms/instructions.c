// Counts the instructions that a program executes under QEMU's user mode emulator, and prints their number at the end.
//
//   gcc -shared -fPIC -O2 -o /tmp/instructions.so tests/platforms/instructions.c
//   qemu-aarch64 -L /usr/aarch64-linux-gnu -plugin /tmp/instructions.so -d plugin PROGRAM ARGUMENTS
//
// Debian has no package with the header of QEMU's plugins, so the functions are declared here.
#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef uint64_t plugin_id;
struct qemu_plugin_tb;
enum operation { ADD_U64 };

extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id id, void (*callback)(plugin_id, struct qemu_plugin_tb *));
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
extern void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb *block, enum operation operation, void *counter,
                                                     uint64_t amount);
extern void qemu_plugin_register_atexit_cb(plugin_id id, void (*callback)(plugin_id, void *), void *data);
extern void qemu_plugin_outs(const char *text);

// The version of the interface that these declarations have.
int qemu_plugin_version = 1;

static uint64_t instructions;

// Is called once for each block of instructions. The emulator adds the block's length whenever the block runs.
static void count_block(plugin_id id, struct qemu_plugin_tb *block) {
    (void)id;
    qemu_plugin_register_vcpu_tb_exec_inline(block, ADD_U64, &instructions, qemu_plugin_tb_n_insns(block));
}

static void print(plugin_id id, void *data) {
    (void)id;
    (void)data;
    char text[64];
    snprintf(text, sizeof text, "%" PRIu64 " instructions\n", instructions);
    qemu_plugin_outs(text);
}

int qemu_plugin_install(plugin_id id, const void *info, int count, char **arguments) {
    (void)info;
    (void)count;
    (void)arguments;
    qemu_plugin_register_vcpu_tb_trans_cb(id, count_block);
    qemu_plugin_register_atexit_cb(id, print, NULL);
    return 0;
}
