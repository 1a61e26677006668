"""Conan 2 recipe for the library mip: run `conan create` in this folder."""

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class Mip(ConanFile):
    name = "mip"
    version = "0.1.0"
    description = "The MIP protocol of MicroStrain (LORD, HBK) inertial sensors"
    license = "MIT"
    topics = ["mip", "imu", "microstrain", "hbk", "lord", "3dm", "inertial sensor", "ahrs", "ins", "gnss", "protocol"]
    languages = "C"
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}
    implements = ["auto_shared_fpic"]
    exports_sources = "CMakeLists.txt", "LICENSE", "cmake/*", "src/*", "ports/*"

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["MIP_INSTALL"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")
        rmdir(self, f"{self.package_folder}/lib/cmake")  # Conan writes its own files for CMake and pkg-config
        rmdir(self, f"{self.package_folder}/lib/pkgconfig")

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "mip")
        library = self.cpp_info.components["mip"]
        library.libs = ["mip"]
        library.set_property("cmake_target_name", "mip::mip")
        library.set_property("pkg_config_name", "mip")
        if self.options.shared:
            library.defines = ["MIP_SHARED"]
        if self.settings.os in ("Linux", "FreeBSD", "Macos", "Windows"):
            ports = self.cpp_info.components["ports"]
            ports.libs = ["mip_ports"]
            ports.requires = ["mip"]
            ports.set_property("cmake_target_name", "mip::ports")
            if self.settings.os == "Windows":
                ports.system_libs = ["ws2_32"]
