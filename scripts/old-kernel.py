#!/usr/bin/env python3
"""Runs a command as on Linux 3.10, the kernel of RHEL 7: system calls that came later answer
that they are not there. On x86-64.

    scripts/old-kernel.py COMMAND [ARGUMENT...]
"""

import ctypes
import errno
import os
import struct
import sys

LAST_OF_3_10 = 313  # finit_module
LOAD, AT_LEAST, RETURN = 0x20, 0x35, 0x06  # instructions of the filter
ALLOW, ERROR = 0x7FFF0000, 0x00050000
NO_NEW_PRIVILEGES, SECCOMP, FILTER = 38, 22, 2

program = b"".join(
    struct.pack("HBBI", *instruction)
    for instruction in [
        (LOAD, 0, 0, 0),  # the number of the call
        (AT_LEAST, 0, 1, LAST_OF_3_10 + 1),
        (RETURN, 0, 0, ERROR | errno.ENOSYS),
        (RETURN, 0, 0, ALLOW),
    ]
)
buffer = ctypes.create_string_buffer(program, len(program))
filter = ctypes.create_string_buffer(struct.pack("HxxxxxxP", 4, ctypes.addressof(buffer)))
libc = ctypes.CDLL(None, use_errno=True)
for request in [(NO_NEW_PRIVILEGES, 1, 0, 0, 0), (SECCOMP, FILTER, filter, 0, 0)]:
    if libc.prctl(*request) != 0:
        sys.exit(f"old-kernel.py: {os.strerror(ctypes.get_errno())}")
# What came later is not there, or this would not be what it says.
if libc.syscall(318, ctypes.create_string_buffer(8), 8, 0) != -1:
    sys.exit("old-kernel.py: getrandom is there all the same")
os.execvp(sys.argv[1], sys.argv[1:])
