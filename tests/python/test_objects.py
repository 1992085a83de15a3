#!/usr/bin/python3
"""Objects of the Python module under everything that Python does with objects: copies, pickles, other processes and threads,
values of wrong types, the end of the interpreter.

PULLOFF_LIBRARY and PYTHONPATH lead to the library and the module."""

import copy
import decimal
import fractions
import gc
import inspect
import itertools
import math
import multiprocessing
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import typing
import unittest
import weakref

import numpy as np

import keys as keys_of_module
import pulloff

PATIENCE = 60  # s, after which a test that hangs fails
PROTOCOLS = range(pickle.HIGHEST_PROTOCOL + 1)
DUPLICATES = {"copy": copy.copy, "deepcopy": copy.deepcopy,
              **{f"pickle {n}": lambda thing, n=n: pickle.loads(pickle.dumps(thing, n)) for n in PROTOCOLS}}


class Named(pulloff.Scene):
    """A scene as a user may extend it."""

    def __init__(self, name, **values):
        super().__init__(**values)
        self.name = name


class PathOfBytes:
    def __init__(self, path):
        self.path = os.fsencode(path)

    def __fspath__(self):
        return self.path


def force(tabor):
    return pulloff.solve(tabor=tabor).pull_off.force


def solve(scene):
    return scene.solve()


def python(source, *arguments, **options):
    """What a script prints. A memory error, a warning or a thread that remains makes it fail."""
    return subprocess.run([sys.executable, "-X", "dev", "-W", "error", "-c", source, *arguments], capture_output=True, text=True,
                          timeout=PATIENCE, check=False, **options)


class Copies(unittest.TestCase):
    def test_scenes(self):
        """copy.copy shared the scene of the library, which was then freed twice."""
        for scene in (pulloff.Scene(), pulloff.Scene(tabor=0.1 + 0.2, waves="1@20;0.2@7", want="curve"), Named("tip", tabor=2)):
            for how, duplicate in DUPLICATES.items():
                with self.subTest(scene=scene, how=how):
                    given = dict(scene)
                    other = duplicate(scene)
                    self.assertIs(type(other), type(scene))
                    self.assertEqual((other, getattr(other, "name", None)), (scene, getattr(scene, "name", None)))
                    other["tabor"] = 5
                    self.assertNotEqual(other, scene)
                    self.assertEqual(dict(scene), given)
                    del other
                    gc.collect()
                    self.assertEqual(scene["radius"], "100")

    def test_results(self):
        result = pulloff.solve(tabor=3, amplitude=1, wavelength=20, want="curve,profile,hysteresis")
        physical = pulloff.Scene.physical(modulus=2e9, work=0.05, distance=3e-10, radius=1e-7).solve()
        for how, duplicate in DUPLICATES.items():
            with self.subTest(how=how):
                other = duplicate(result)
                self.assertEqual(other, result)
                self.assertEqual(other["digest"], result["digest"])
                self.assertEqual(other.digest, result["digest"])
                self.assertEqual((other.pull_off, other.status, other.reason), (result.pull_off, "ok", ""))
                for name in ("folds", "extrema", "curve", "profile"):
                    one, two = getattr(other, name), getattr(result, name)
                    self.assertEqual(one.dtype, two.dtype)
                    for field in one.dtype.names:  # the bytes between the fields are not copied
                        self.assertEqual(one[field].tobytes(), two[field].tobytes())
                self.assertEqual(duplicate(physical.units), physical.units)
                self.assertEqual(duplicate(physical).units, physical.units)

    def test_exceptions(self):
        """An exception that cannot be read back made a pool of processes wait forever."""
        errors = []
        for values in ({"tabor": -1}, {"tabor": 5, "amplitude": 2, "wavelength": 9, "preload_load": 1, "time_limit": 1e-6}):
            with self.assertRaises(pulloff.Error) as caught:
                pulloff.solve(**values)
            caught.exception.note = "of a user"
            errors.append(caught.exception)
        for error, (how, duplicate) in itertools.product(errors, DUPLICATES.items()):
            with self.subTest(error=error, how=how):
                other = duplicate(error)
                self.assertIs(type(other), type(error))
                self.assertEqual((str(other), other.args, other.status, other.note),
                                 (str(error), error.args, error.status, error.note))
                self.assertEqual(getattr(other, "result", 0), getattr(error, "result", 0))
        self.assertEqual(errors[1].result.status, "out_of_time")
        self.assertEqual(str(pulloff.Error("a message of one's own")), "a message of one's own")

    def test_names_in_pickles(self):
        """A pickle names public classes only, and a scene by its texts, so that other versions read it."""
        result = pulloff.solve(tabor=1)
        for thing in (pulloff.Scene(tabor=3), pulloff.Error("text"), result, result.pull_off):
            self.assertNotIn(b"pulloff.", pickle.dumps(thing, 0).replace(b"pulloff.Scene", b""), thing)
        stored = (b"ccopyreg\n__newobj__\n(cpulloff\nScene\ntR(N(V_given\n(Vtabor\nV3\nVprofile\nVcone:0.3\ndd"
                  b"tb.")
        self.assertEqual(pickle.loads(stored), pulloff.Scene(tabor=3, profile="cone:0.3"))
        other = pickle.loads(stored.replace(b"Vtabor", b"Vviscosity"))
        self.assertEqual(list(other), ["viscosity", "profile"])
        with self.assertRaisesRegex(pulloff.Error, "^unknown key viscosity of a scene: expected one of pulloff.keys"):
            other.solve()


class Mappings(unittest.TestCase):
    def test_scenes(self):
        scene = pulloff.Scene(tabor=3, amplitude=1, wavelength=20, profile="cone:0.3", want=["profile", "curve"])
        self.assertEqual(list(scene), ["tabor", "amplitude", "wavelength", "profile", "want"])
        self.assertEqual((len(scene), "tabor" in scene, "radius" in scene, 3 in scene), (5, True, False, False))
        for other in (pulloff.Scene(**scene), pulloff.Scene(dict(scene)), pulloff.Scene(scene), eval(repr(scene))):
            self.assertEqual(other, scene)
        self.assertNotEqual(pulloff.Scene(scene, tabor=2), scene)
        scene.update({"tabor": 2}, want=None)
        self.assertEqual((scene["tabor"], "want" in scene), ("2", False))
        with self.assertRaises(pulloff.Error):
            scene.update(tabor=5, radius=-1)
        self.assertEqual(scene["tabor"], "2")  # all or nothing
        for name in list(scene):
            del scene[name]
        self.assertEqual(scene, pulloff.Scene())
        with self.assertRaises(AttributeError):
            scene.tabor = 3  # which would have no effect
        with self.assertRaises(TypeError):
            hash(scene)

    def test_a_scene_that_does_not_agree_is_shown(self):
        scene = pulloff.Scene(tabor=1, nodes=101)  # refused with panels; repr() used to fail, too
        self.assertEqual((repr(scene), scene["nodes"]), ("pulloff.Scene(tabor=1, nodes=101)", "101"))
        for what in (scene.solve, lambda: scene["radius"], lambda: scene.units):
            with self.assertRaisesRegex(pulloff.Error, "nodes is 101: expected"):
                what()

    def test_results(self):
        result = pulloff.solve(tabor=1)
        self.assertEqual(dict(result), result.document)
        self.assertIn("pull_off", result)
        self.assertNotIn(0, result)
        with self.assertRaises(TypeError):
            pulloff.Result(1)


class Processes(unittest.TestCase):
    def test_pools(self):
        single = [force(tabor) for tabor in (0.5, 1, 1.5)]
        scenes = [pulloff.Scene(tabor=tabor, want="curve") for tabor in (0.5, 1)]
        for method in multiprocessing.get_all_start_methods():
            with self.subTest(method=method), multiprocessing.get_context(method).Pool(2) as pool:
                self.assertEqual(pool.map_async(force, (0.5, 1, 1.5)).get(PATIENCE), single)
                with self.assertRaisesRegex(pulloff.Error, "tabor is -1: expected a finite number >= 0"):
                    pool.map_async(force, (0.5, -1, 1)).get(PATIENCE)
                for result, scene in zip(pool.map_async(solve, scenes).get(PATIENCE), scenes):
                    self.assertEqual(result["digest"], scene.solve()["digest"])
                with self.assertRaises(pulloff.SolveError) as caught:
                    pool.apply_async(pulloff.solve, (), {"tabor": 5, "time_limit": 1e-6}).get(PATIENCE)
                self.assertEqual((caught.exception.status, caught.exception.result.status), (9, "out_of_time"))

    def test_forks_beside_threads(self):
        """A child solves that was forked while another thread held a lock of the library. It used to wait for ever. Twenty children, or as
        many as solve in half a minute."""
        said = python("import os, pulloff, threading, time, warnings\n"
                      "warnings.simplefilter('ignore')\n"  # Python 3.12 warns of forks beside threads
                      "going = True\n"
                      "def work(call):\n"
                      "    while going:\n"
                      "        call(tabor=0.5)\n"
                      "threads = [threading.Thread(target=work, args=(call,)) for call in [pulloff.solve, *4 * [pulloff.Scene]]]\n"
                      "[thread.start() for thread in threads]\n"
                      "begin = time.monotonic()\n"
                      "for k in range(20):\n"
                      "    if k > 2 and time.monotonic() - begin > 30:\n"
                      "        break\n"
                      "    child = os.fork()\n"
                      "    if not child:\n"
                      "        os._exit(0 if pulloff.solve(tabor=0.5).status == 'ok' else 1)\n"
                      "    assert os.waitpid(child, 0)[1] == 0\n"
                      "going = False\n")
        self.assertEqual((said.returncode, said.stderr), (0, ""))


class Threads(unittest.TestCase):
    def test_a_scene_that_changes_while_it_is_solved(self):
        scene, found, stop = pulloff.Scene(tabor=1), [], threading.Event()
        expected = {force(1), force(2)}

        def change():
            for text in itertools.cycle((1, 2)):
                scene["tabor"] = text
                if stop.is_set():
                    return

        def use():
            for _ in range(5):
                copy.deepcopy(scene), repr(scene), dict(scene)
                found.append(scene.solve().pull_off.force)

        threads = [threading.Thread(target=change), *(threading.Thread(target=use) for _ in range(3))]
        for thread in threads:
            thread.start()
        for thread in threads[1:]:
            thread.join()
        stop.set()
        threads[0].join()
        self.assertEqual(len(found), 15)
        self.assertLessEqual(set(found), expected)


    def test_keys_that_two_threads_set(self):
        scene = pulloff.Scene()

        def work(key):
            for _ in range(300):
                scene[key] = 5
                self.assertEqual(scene[key], "5")
                del scene[key]
                scene[key] = 7

        threads = [threading.Thread(target=work, args=(key,)) for key in ("tabor", "radius", "amplitude", "wavelength")]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(scene, pulloff.Scene(tabor=7, radius=7, amplitude=7, wavelength=7))


class Broken:
    """An object of which nothing works."""

    def __repr__(self):
        raise RuntimeError("of a user")

    __str__ = __float__ = __index__ = __len__ = __iter__ = __repr__


REFUSED = [True, False, math.nan, b"1", bytearray(b"1"), memoryview(b"1"), 1j, decimal.Decimal("nan"), decimal.Decimal("sNaN"),
           decimal.Decimal("1e999"), decimal.Decimal("1e-999"), fractions.Fraction(10**400), fractions.Fraction(1, 10**400),
           10**400, 10**5000, np.bool_(True), np.complex128(1), np.bytes_(b"1"), np.datetime64(1, "s"), np.timedelta64(1, "s"),
           np.longdouble("1e4000"), np.longdouble("1e-4000"), np.array([1.0]), np.array([[1.0]]), np.array(True), np.array(1j),
           np.array("1"), np.array(1, "m8[s]"), np.ma.masked, np.ma.array(1.0), np.ma.array([1.0], mask=[True]), "1\0", "\0",
           "\ud800", "\udc80", "ä" * 2000, "1" * 2000, "", [1], (1, 2), {1}, {"a": 1}, range(2), iter([1]), object(), Broken(),
           Broken, int, pulloff, pulloff.Scene()]
SAME = [(3, 3), (3.0, 3), (np.int8(3), 3), (np.uint64(2**63), 2**63), (np.float16(1.5), 1.5), (np.float32(0.1), float(np.float32(0.1))),
        (np.longdouble(0.5), 0.5), (decimal.Decimal("0.1"), 0.1), (fractions.Fraction(1, 3), 1 / 3), (np.array(0.1), 0.1), (2**60 + 1, 2**60),
        (np.array(3), 3), ("0.1", 0.1), (np.str_("0.1"), 0.1)]


class Types(unittest.TestCase):
    def test_values_of_keys(self):
        """Each is refused with the key, the value and what is expected, or is taken as the same number."""
        for key, expected in pulloff.keys().items():
            for value in REFUSED:
                if (key == "want" and isinstance(value, str) and not value) or (key == "profile_file" and value is REFUSED[3]):
                    continue  # no names; a path
                if key in ("young_pa", "radius_m", "surface_energies_j_per_m2") and isinstance(value, tuple):
                    continue  # two bodies
                scene = pulloff.Scene(radius=7)
                with self.subTest(key=key), self.assertRaises(pulloff.Error) as caught:
                    scene[key] = value
                said = str(caught.exception)
                self.assertTrue(key == "profile_file" or (said.startswith(key + " is ") and "expected" in said), said)
                self.assertLess(len(said), 700)
                self.assertEqual((scene["radius"], len(scene)), ("7", 1))
        for value, number in SAME:
            self.assertEqual(float(pulloff.Scene(tabor=value)["tabor"]), number, repr(value))
        for value in (True, 3, 3.0, ["a"], np.array("x")):
            with self.assertRaisesRegex(pulloff.Error, "^profile_file is .*: expected a CSV file"):
                pulloff.Scene(profile_file=value)
        for value in (3, b"curve", ["curve", 3], ["curve", "all"], [["curve"]]):
            with self.assertRaisesRegex(pulloff.Error, "^want is .*: expected any of curve, "):
                pulloff.Scene(want=value)

    def test_names_of_keys(self):
        scene = pulloff.Scene()
        for key in (3, None, b"tabor", "tabor\0", "\ud800", "", "Tabor", "x" * 5000, (1,), Broken()):
            for use in (lambda: scene[key], lambda: scene.update({key: 1}), lambda: scene.__delitem__(key),
                        lambda: pulloff.follow(key, [1, 2])):
                with self.assertRaisesRegex(pulloff.Error, "expected "):
                    use()
            self.assertNotIn(key, scene)
        for wrong in (3, "tabor", [("tabor", 3)], scene.solve):
            for use in (pulloff.Scene, scene.update, pulloff.solve, lambda wrong: pulloff.follow("tabor", [1], wrong),
                        lambda wrong: pulloff.theory("jkr", scene=wrong)):
                with self.assertRaisesRegex(pulloff.Error, "expected (a pulloff.Scene|keyword arguments, a scene or a dict)"):
                    use(wrong)

    def test_values_of_a_series(self):
        """follow() solved one of three values of an array of another shape, and those behind a mask."""
        with self.assertRaises(pulloff.Error):
            pulloff.follow("tabor", [])
        for values in (3, np.array(3.0), np.ones((1, 3)), np.ones((3, 1)), np.ma.array([1, 2, 3], mask=[0, 1, 0]), "123", b"123",
                       {1: 2}, None, Broken):
            with self.assertRaisesRegex(pulloff.Error, "^values is .*: expected a one-dimensional sequence of real numbers"):
                pulloff.follow("tabor", values)
        for value in [value for value in REFUSED if not isinstance(value, float)]:
            with self.assertRaisesRegex(pulloff.Error, r"^values\[1\] of tabor is (.|\n)*: expected a finite number >= 0"):
                pulloff.follow("tabor", [1, value])
        expected = [one.pull_off for one in pulloff.follow("tabor", [1, 2])]
        for values in ((1, 2), np.array([1, 2]), np.array([1, 2], np.float32), range(1, 3), iter([1, 2]), [decimal.Decimal(1), 2]):
            self.assertEqual([one.pull_off for one in pulloff.follow("tabor", values)], expected)
        with self.assertRaisesRegex(pulloff.Error, "^tabor is 3: expected it to be left out, as its value varies"):
            pulloff.follow("tabor", [1, 2], tabor=3)

    def test_other_arguments(self):
        for name, value in itertools.product(("at", "alpha"), [*REFUSED, "1"]):
            with self.assertRaisesRegex(pulloff.Error, f"^{name} is "):
                pulloff.theory("guduru", amplitude=1, **{name: value})
        for form in (3, None, b"jkr", "jkr\0", "\ud800", "", "nobody"):
            with self.assertRaisesRegex(pulloff.Error, "expected"):
                pulloff.theory(form)
        for progress in (1, "yes", Broken()):
            with self.assertRaisesRegex(pulloff.Error, "^progress is .*: expected True, False or a function"):
                pulloff.follow("tabor", [1], progress=progress)
        with self.assertRaisesRegex(pulloff.Error, "^want is curve|^want is 'curve'"):
            pulloff.Scene().compare(want="curve")

    def test_waves(self):
        for waves in ([(1, 20), (0.2, 7)], ((1, "20"), [0.2, np.float64(7)]), np.array([[1, 20], [0.2, 7]])):
            self.assertEqual(pulloff.Scene(waves=waves), pulloff.Scene(waves="1@20;0.2@7"))
        self.assertEqual(pulloff.Scene(waves=[])["waves"], "-")
        for waves in ((1, 20), [(1,)], [(1, 20, 3)], [[(1, 20)]], [1], [(True, 20)], [("1;2", 3)], [("1@5;2", 3)], np.ones(2), np.ones((2, 3)),
                      np.ma.array([[1, 20]]), [(1, math.nan)], [(1, 0)], [(1, 20)] * 9, {1: 20}, [None]):
            with self.assertRaisesRegex(pulloff.Error, "^waves is .*expected A@L"):
                pulloff.Scene(waves=waves)

    def test_paths(self):
        table = "r,gap\n" + "".join(f"{r},{r * r / 200}\n" for r in range(0, 61, 2))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, os.fsdecode(b"tip \xe4.csv"))  # no UTF-8, as on old disks
            path.write_text(table, encoding="ascii")
            found = [pulloff.solve(profile_file=one, coupling=0.1) for one in (str(path), path, PathOfBytes(path), os.fsencode(path))]
            self.assertEqual({one["digest"] for one in found}, {found[0]["digest"]})
            scene = pickle.loads(pickle.dumps(pulloff.Scene(profile_file=path, coupling=0.1)))
            self.assertEqual(scene.solve()["digest"], found[0]["digest"])
            path.unlink()
            with self.assertRaisesRegex(pulloff.Error, "tip .*csv"):
                scene.solve()

    def test_a_preload_without_unit_beside_si_units(self):
        """It was taken in epsilon. The command line refuses it."""
        tip = {"modulus": 2e9, "work": 0.05, "distance": 3e-10, "radius": 1e-7}
        for name in ("preload", "preload_load", "stiffness", "approach_end", "profile_approach"):
            with self.assertRaisesRegex(pulloff.Error, f"^{name} is 1: expected {name}_.*, as the scene is in SI units"):
                pulloff.Scene.physical(**tip, **{name: 1})
        scene = pulloff.Scene.physical(**tip, preload_m=3e-10)
        self.assertEqual(pulloff.Scene.physical(**tip, amplitude=0, wavelength=1e-8, outer_radius=math.inf, preload_m=3e-10), scene)
        with self.assertRaisesRegex(pulloff.Error, "^modulus_pa is True: expected"):
            pulloff.Scene.physical(**{**tip, "modulus": True})


class Progress(unittest.TestCase):
    TABOR = np.geomspace(0.3, 3, 40)

    def test_it_grows_and_ends(self):
        seen, threads = [], set()

        def show(number, count):
            seen.append((number, count))
            threads.add(threading.current_thread())

        def run():
            pulloff.follow("tabor", self.TABOR, amplitude=1, wavelength=20, progress=show)

        run()
        other = threading.Thread(target=run)
        other.start()
        other.join()
        self.assertEqual(threads, {threading.main_thread(), other})  # that of the caller
        cut = seen.index((40, 40)) + 1
        for part in (seen[:cut], seen[cut:]):
            self.assertEqual(part[-1], (40, 40))
            self.assertEqual(part, sorted(set(part)))
        self.assertEqual(seen.count((40, 40)), 2)

    def test_its_exceptions_end_the_series(self):
        def show(seen, count):
            raise ZeroDivisionError(f"{seen} of {count}")

        with self.assertRaisesRegex(ZeroDivisionError, "^[0-9]+ of 40$"):
            pulloff.follow("tabor", self.TABOR, amplitude=1, wavelength=20, progress=show)

    def test_a_line(self):
        said = python("import pulloff; pulloff.follow('tabor', [1, 1.1, 1.2], progress=True)")
        self.assertEqual((said.returncode, said.stdout), (0, ""))
        self.assertRegex(said.stderr, r"^(\n[0-9]+/3 scenes)*\n3/3 scenes\n$")

    def test_interrupts_end_a_series(self):
        """The first ends the series, those that follow while it ends do no harm."""
        said = python("import numpy, pulloff, signal\n"
                      "def interrupt(number, frame):\n"
                      "    while frame and frame.f_code.co_name != 'interruptible':\n"
                      "        frame = frame.f_back\n"
                      "    if frame:\n"
                      "        raise KeyboardInterrupt\n"
                      "signal.signal(signal.SIGALRM, interrupt)\n"
                      "signal.setitimer(signal.ITIMER_REAL, 0.5, 0.001)\n"
                      "try:\n"
                      "    pulloff.follow('tabor', numpy.linspace(7, 8, 3000), amplitude=8, wavelength=16, tolerance=1e-9)\n"
                      "except KeyboardInterrupt:\n"
                      "    print('interrupted')\n"
                      "signal.setitimer(signal.ITIMER_REAL, 0)\n"
                      "print(pulloff.solve(tabor=1).status)\n")
        self.assertEqual((said.stdout, said.stderr, said.returncode), ("interrupted\nok\n", "", 0))


class Lifetime(unittest.TestCase):
    def test_results_outlive_scenes(self):
        scene = pulloff.Scene(tabor=1, want="curve")
        result = scene.solve()
        del scene
        gc.collect()
        np.testing.assert_array_equal(result.curve, pulloff.solve(tabor=1, want="curve").curve)
        result.curve["load"] = 0  # a copy that belongs to the caller

    def test_cycles_are_collected(self):
        scene = Named("tip", tabor=1)
        scene.itself, reference = scene, weakref.ref(scene)
        self.assertEqual(copy.deepcopy(scene).itself.itself["tabor"], "1")
        del scene
        gc.collect()
        self.assertIsNone(reference())

    def test_a_scene_that_was_not_initialised(self):
        self.assertEqual(pulloff.Scene.__new__(pulloff.Scene), pulloff.Scene())

    def test_the_end_of_the_interpreter(self):
        said = python("import atexit, pulloff, threading\n"
                      "def work():\n"
                      "    while True:\n"
                      "        pulloff.solve(tabor=0.5, want='curve')\n"
                      "atexit.register(lambda: print(pulloff.solve(tabor=1).status, flush=True))\n"
                      "threading.Thread(target=work, daemon=True).start()\n"
                      "pulloff.solve(tabor=1)\n")
        self.assertEqual((said.returncode, said.stdout, said.stderr), (0, "ok\n", ""))


class Uncertain(unittest.TestCase):
    def test_numbers_with_uncertainty(self):
        """The force is that of the plain number; series and closed forms take none."""
        plain, uncertain = pulloff.solve(tabor=1.385), pulloff.solve(tabor="1.385+-0.001")
        self.assertEqual(plain.pull_off.force, uncertain.pull_off.force)
        self.assertGreater(uncertain["uncertainty"]["sources"][0]["force"], 0)
        scene = pulloff.Scene(tabor="1+-0.1")
        self.assertEqual(scene["tabor"], "1+-0.1")
        for use in (lambda: pulloff.follow("radius", [100, 110], scene), lambda: pulloff.theory("jkr", tabor="1+-0.1")):
            with self.assertRaisesRegex(pulloff.Error, "only solve and cases take it"):
                use()
        with self.assertRaisesRegex(pulloff.Error, "tabor is '1\\+-0.1': expected a number without uncertainty"):
            scene.compare()
        for key, text, expected in (("tabor", "1+-0", "its uncertainty > 0"), ("tabor", "1+-2", "moved by twice its uncertainty"),
                                    ("scheme", "ring+-1", "a value without uncertainty")):
            with self.assertRaisesRegex(pulloff.Error, expected):
                pulloff.solve(**{key: text})


class Signatures(unittest.TestCase):
    def test_they_name_the_keys(self):
        for function in (pulloff.Scene, pulloff.Scene.update, pulloff.Scene.solve, pulloff.Scene.compare, pulloff.Scene.physical,
                         pulloff.solve, pulloff.follow, pulloff.theory):
            self.assertLessEqual(set(pulloff.keys()), set(inspect.signature(function).parameters), function)
            inspect.signature(function).bind_partial(tabor=1)
        for key in pulloff.keys():
            self.assertRegex(pulloff.Scene.__doc__, rf"\n    {key}: [^;]")
        self.assertNotIn("--", pulloff.Scene.__doc__)

    def test_type_hints(self):
        """The keys that editors see are those of the library. After a change of them: keys.py --write."""
        self.assertEqual((keys_of_module.FOLDER / "_keys.py").read_text(encoding="utf-8"), keys_of_module.text())
        if sys.version_info >= (3, 11):
            for function in (pulloff.Scene.__init__, pulloff.Scene.solve, pulloff.follow, pulloff.theory, pulloff.SolveError.__init__):
                self.assertIn("return", typing.get_type_hints(function))
        self.assertTrue((pathlib.Path(pulloff.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
