"""Compiles the innermost loops of columns: one module for all versions of Python.

Without a compiler, or with MIP_TOOLS_PURE=1, the package has none, and NumPy does everything.
"""

import os

from setuptools import Extension, setup

KERNEL = Extension(
    "mip_tools.columns._kernel",
    ["mip_tools/columns/kernel.c"],
    define_macros=[("MIP_MODULE", "1"), ("Py_LIMITED_API", "0x030A0000")],
    extra_compile_args=[] if os.name == "nt" else ["-O3", "-std=c99"],
    py_limited_api=True,
    optional=True,
)

if os.environ.get("MIP_TOOLS_PURE"):
    setup()
else:
    setup(ext_modules=[KERNEL], options={"bdist_wheel": {"py_limited_api": "cp310"}})
