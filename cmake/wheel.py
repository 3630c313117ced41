"""The build backend of pyproject.toml (PEP 517): a wheel (PEP 427) of what `cmake --install` puts into the package."""
import base64
import hashlib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
#: What the build needs.
PARTS = ("CMakeLists.txt", "LICENSE", "README.md", "CITATION.cff", "pyproject.toml", "cmake", "include", "src")


def version():
    return re.search(r"project\(bondstatic VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def metadata():
    return (f"Metadata-Version: 2.1\nName: bondstatic\nVersion: {version()}\n"
            "Summary: The static answer of a bonded-particle DEM model\nRequires-Python: >=3.9\n"
            "Requires-Dist: numpy\nRequires-Dist: scipy\nDescription-Content-Type: text/markdown\n\n"
            + (ROOT / "README.md").read_text(encoding="utf-8"))


def install_package(prefix, build):
    """The package below the prefix, built by CMake for this interpreter."""
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DBONDSTATIC_PYTHON=ON", "-DBONDSTATIC_PETSC=OFF",
               f"-DPython_EXECUTABLE={sys.executable}", "-DBONDSTATIC_PYTHON_DIR=.",
               *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
    subprocess.run(["cmake", "-S", ROOT, "-B", build, *options], check=True)
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
    subprocess.run(["cmake", "--build", build, "--parallel", jobs, "--target", "python_package"], check=True)
    subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", "python", "--strip"],
                   check=True)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory(prefix="bondstatic-wheel-") as folder:
        prefix = pathlib.Path(folder) / "prefix"
        # BONDSTATIC_BUILD: a folder that is kept, so that the next build is quick.
        install_package(prefix, os.environ.get("BONDSTATIC_BUILD", f"{folder}/build"))
        return pack(prefix, wheel_directory)


def pack(prefix, wheel_directory):
    """The wheel of the package that lies in the prefix; returns its name."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"bondstatic-{version()}-{tag}.whl"
    info = f"bondstatic-{version()}.dist-info"
    files = {str(path.relative_to(prefix)): path.read_bytes() for path in sorted(prefix.rglob("*")) if path.is_file()}
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: bondstatic\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/licenses/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(f"{path},sha256={digest(content)},{len(content)}\n" for path, content in files.items())
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name


def digest(content):
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def build_sdist(sdist_directory, config_settings=None):
    base = f"bondstatic-{version()}"
    with tarfile.open(pathlib.Path(sdist_directory) / f"{base}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as sdist:
        for part in PARTS:
            sdist.add(ROOT / part, f"{base}/{part}", filter=lambda item: None if "__pycache__" in item.name else item)
        facts = pathlib.Path(sdist_directory) / "PKG-INFO"
        facts.write_text(metadata(), encoding="utf-8")
        sdist.add(facts, f"{base}/PKG-INFO")
        facts.unlink()
    return f"{base}.tar.gz"
