"""Packs the module and a library into a wheel, for pip (PEP 427). The same input gives the same bytes.

Usage: wheel.py LIBRARY FOLDER [LICENCE...]

LIBRARY: libpulloff as a shared library of Linux or a DLL. Its header says for which processor it is, and on Linux which glibc
it needs; the tag of the wheel says both. LICENCE: further files with the licences of what is in it. Prints the name of the
wheel, which it writes to FOLDER.
"""

import base64
import hashlib
import pathlib
import re
import struct
import subprocess
import sys
import tomllib
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
PROCESSORS = {62: "x86_64", 183: "aarch64"}  # e_machine of ELF


def platform_of(library):
    """The platform tag, and the name that _library.py looks for."""
    head = library.read_bytes()[:20]
    if head[:2] == b"MZ":
        return "win_amd64", "libpulloff-0.dll"
    table = subprocess.run(["objdump", "-p", library], capture_output=True, text=True, check=True).stdout
    glibc = max(int(minor) for minor in re.findall(r"GLIBC_2\.(\d+)", table))
    return f"manylinux_2_{glibc}_{PROCESSORS[struct.unpack_from('<H', head, 18)[0]]}", "libpulloff.so.0"


def metadata_of(project):
    fields = {"Metadata-Version": "2.1", "Name": project["name"], "Version": project["version"], "Summary": project["description"],
              "License": project["license"]["text"], "Requires-Python": project["requires-python"],
              "Description-Content-Type": "text/markdown"}
    lines = [f"{name}: {value}" for name, value in fields.items()] + [f"Requires-Dist: {name}" for name in project["dependencies"]]
    return "\n".join(lines) + "\n\n" + (HERE / project["readme"]).read_text(encoding="utf-8")


def main():
    library, folder, *licences = map(pathlib.Path, sys.argv[1:])
    project = tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    platform, name = platform_of(library)
    stem, tag = f"{project['name']}-{project['version']}", f"py3-none-{platform}"
    info = f"{stem}.dist-info"
    files = {f"pulloff/{path.name}": path.read_bytes() for path in sorted((HERE / "pulloff").iterdir()) if path.is_file()}
    files[f"pulloff/{name}"] = library.read_bytes()
    for licence in (HERE.parent / "LICENSE", *licences):
        files[f"{info}/licenses/{licence.parent.name + '-' if licence in licences else ''}{licence.name}"] = licence.read_bytes()
    files[f"{info}/METADATA"] = metadata_of(project).encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: pulloff\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    record = "".join(f"{path},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip('=')},{len(data)}\n"
                     for path, data in files.items())
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / f"{stem}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path)
            entry.external_attr, entry.compress_type = 0o100644 << 16, zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    print(wheel)


if __name__ == "__main__":
    main()
