"""Where the interpreter looks for packages below a prefix, relative to it. Usage: install_folder.py PREFIX"""
import pathlib
import sys
import sysconfig


def folder_of(prefix):
    """Debian has folders of its own: what its packages install is in one, what is installed by hand in another."""
    base = pathlib.Path(sys.base_prefix)
    of_system = prefix == base and "deb_system" in sysconfig.get_scheme_names()
    packages = pathlib.Path(sysconfig.get_path("platlib", "deb_system") if of_system else sysconfig.get_path("platlib"))
    for top in (base / "local", pathlib.Path(sys.prefix), base):
        if packages.is_relative_to(top):
            return packages.relative_to(top)
    return pathlib.Path(f"lib/python{sys.version_info.major}.{sys.version_info.minor}/site-packages")


print(folder_of(pathlib.Path(sys.argv[1])))
