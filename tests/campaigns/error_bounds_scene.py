"""Random scenes of tests/campaigns/error_bounds."""
import math
import random
import statistics

BASES = {2: "carter_2d_partial_slip.prm", 3: "lateral_3d_partial_slip.prm"}
REFINEMENT = {2: 4, 3: 2}
BOTH = ("Wheel", "Rail")
THICKNESS = 0.02  # m, of the 2D base scene
# what scenes are drawn of, with their weights
BODIES = {"thick discs": 4, "thin rail block": 2, "layer": 1, "thin rims": 1}
MATERIALS = {"steel": 6, "different materials": 2, "rigid rail": 1, "nearly incompressible": 1}
POISSON_RATIOS = {"different materials": (0.25, 0.35), "nearly incompressible": (0.45, 0.499)}
SURFACES = {"smooth": 5, "rough": 1}
DIRECTIONS = {"longitudinal": 2, "lateral": 2, "spin": 2, "combined": 3}
OPERATORS = {"calibrated": 10, "upwind 2": 1, "upwind 1": 1}
SOLVERS = {"automatic": 6, "accelerated projection": 1}
RIM_LEVELS = {0: 8, 1: 1}
ADAPTIVE_LEVELS = {0: 8, 1: 1, 2: 1}
FRICTION_LAWS = {"constant": 8, "rational": 1, "exponential": 1}
FALLING_LAWS = {"rational": 1, "exponential": 1}
DRIVES = {"creepages": 7, "force": 1}
PRESSED = {"load": 5, "approach": 1}
FRICTION = (0.02, 1.2)
GROWTHS = {2: (0.05, 2), 3: (0.2, 2)}
REFERENCE_GROWTHS = {2: 0.05, 3: 0.4}
ALWAYS = {"Body threads": 1, "Output/Plot": "false", "Output/Body fields": "false",
          "Output/Interface fields": "false", "Contact/Approach": ""}
KEPT = {"Mesh/Elements across patch", "Mesh/Growth", "Contact/Friction coefficient"}  # in each scene
REFERENCE = {"Mesh/Patch offset": 0.375, "Mesh/Rim levels": 0, "Mesh/Adaptive levels": 0,
             "Contact/Slip operator": "calibrated", "Contact/Solver": "automatic",
             "Contact/Tolerance": 1e-10}


class Scene:
    """A random scene: its kinds, and entries over those of the base scene.

    Where its `approach` is given, the command asks for the load that has it; the
    scene itself is made by under_approach() of what that run found.
    """

    def __init__(self, number, options):
        self.random = random.Random(f"{options.seed} {number}")
        self.number = number
        self.laws = FALLING_LAWS if options.falling else FRICTION_LAWS
        drawn = 3 if self.random.random() < 0.2 else 2
        self.dimension = {"both": drawn, "profiles": 3}.get(options.dimension) or int(options.dimension)
        self.entries = dict(ALWAYS)
        self.kinds = [f"{self.dimension}D"]
        self.n = self.random.randint(*((12, 48) if self.dimension == 2 else (8, 13)))
        self.draw_profiles()
        self.draw_materials()
        self.draw_load_and_depths()
        self.draw_roughness()
        self.draw_creepages()
        self.draw_method()
        self.base = [str(options.program), str(options.prm / BASES[self.dimension])]

    @property
    def command(self):
        return self.base + settings(self.entries)

    @property
    def changes(self):
        """What makes a reference of the scene."""
        growth = min(self.entries["Mesh/Growth"], REFERENCE_GROWTHS[self.dimension])
        return settings({"Mesh/Elements across patch": REFINEMENT[self.dimension] * self.n,
                         "Mesh/Growth": growth, **REFERENCE})

    def under_approach(self, approach):
        """Press the bodies by the approach that their load was found to have, m."""
        self.entries["Contact/Normal load"] = ""
        self.entries["Contact/Approach"] = float(approach)

    def kind(self, weights):
        kind = self.random.choices(list(weights), list(weights.values()))[0]
        self.kinds.append(str(kind))
        return kind

    def scale(self, low, high):
        """Between the two, all orders of magnitude alike."""
        return low * (high / low) ** self.random.random()

    def draw_profiles(self):
        bodies = self.kind(BODIES)
        block = bodies in ("thin rail block", "layer")
        self.entries["Wheel/Radius"] = self.random.uniform(0.3, 0.6)
        self.entries["Rail/Radius"] = 0 if block else self.random.uniform(0.3, 0.6)
        self.entries["Rail/Shape"] = "block" if block else "disc"
        if self.dimension == 3:  # a/b of 0.3 to 3
            lateral = self.scale(0.3, 3) ** (-1 / 0.636) / self.curvature("Radius")
            self.entries["Wheel/Lateral radius"] = lateral if block else 2 * lateral
            self.entries["Rail/Lateral radius"] = 0 if block else 2 * lateral
            for body in BOTH:
                self.entries[f"{body}/Width"] = min(0.1, 1.5 * lateral * (1 if block else 2))

    def draw_materials(self):
        kind = self.kind(MATERIALS)
        moduli = (70e9, 210e9) if kind == "different materials" else (210e9, 210e9)
        for body in BOTH:
            ratio = self.random.uniform(*POISSON_RATIOS.get(kind, (0.3, 0.3)))
            self.entries[f"{body}/Young modulus"] = self.random.uniform(*moduli)
            self.entries[f"{body}/Poisson ratio"] = ratio
        self.entries["Rail/Rigid"] = "true" if kind == "rigid rail" else "false"

    def draw_load_and_depths(self):
        self.load = self.scale(3e4, 3e5) if self.dimension == 2 else self.scale(5e3, 150e3)
        self.entries["Contact/Normal load"] = self.load
        self.half_widths = self.hertz()
        depth = {"thin rail block": (3, 50), "layer": (1, 3)}
        for bodies, limits in depth.items():
            if bodies in self.kinds:
                self.entries["Rail/Block depth"] = self.half_widths[0] * self.scale(*limits)
        for body in BOTH if "thin rims" in self.kinds else ():
            rim = self.half_widths[0] * self.scale(2, 15)
            self.entries[f"{body}/Hub radius"] = self.entries[f"{body}/Radius"] - rim

    def draw_roughness(self):
        """A wave of 3 to 30 elements, of 0.1 to 3 times the mean curvature."""
        if self.kind(SURFACES) == "rough":
            axis = self.random.randrange(self.dimension - 1)
            number = math.pi * self.n / self.half_widths[axis] / self.random.uniform(3, 30)
            mean = statistics.mean(self.curvature(radius) for radius in
                                   ("Radius", "Lateral radius")[:self.dimension - 1])
            height, phase = self.scale(0.1, 3) * mean / number ** 2, self.random.uniform(0, 6.28)
            self.entries["Contact/Roughness"] = (
                f"{height:.6g}*cos({number:.6g}*{'xy'[axis]}+{phase:.6g})")

    def draw_creepages(self):
        """Over those at which all slides (2D) or Kalker's linear force is 3 mu N."""
        share = self.random.uniform(0.05, 1.2) * self.random.choice([-1, 1])
        self.mu = self.entries["Contact/Friction coefficient"] = self.scale(*FRICTION)
        if self.dimension == 2:
            largest = self.mu * self.half_widths[0] * self.curvature("Radius")
            self.entries["Contact/Creepage x"] = share * largest
        else:
            self.draw_direction(share)
        law = self.kind(self.laws)
        if law != "constant":
            self.entries.update({
                "Contact/Speed": self.random.uniform(5, 40), "Contact/Friction law": law,
                "Contact/Kinetic friction coefficient": self.mu * self.random.uniform(0.4, 0.95),
                "Contact/Friction decay speed": self.scale(0.1, 2)})
        elif self.kind(DRIVES) == "force":
            self.entries["Contact/Creepage x"] = ""
            self.entries["Contact/Longitudinal force"] = (
                self.random.uniform(0.03, 0.95) * self.random.choice([-1, 1]) * self.mu * self.load
                * (1 if self.dimension == 2 else 0.7))

    def draw_direction(self, share):
        kind = self.kind(DIRECTIONS)
        shear, c = 0.75 * self.modulus(), math.sqrt(math.prod(self.half_widths))
        largest = 3 * self.mu * self.load / (4.5 * shear * c ** 2)  # G of equal bodies, nu near 0.3
        angle = {"longitudinal": 0, "lateral": math.pi / 2}.get(kind, self.random.uniform(0, 6.28))
        for component, part in (("x", math.cos(angle)), ("y", math.sin(angle))):
            self.entries[f"Contact/Creepage {component}"] = (
                0 if kind == "spin" else share * largest * part)
        if kind in ("spin", "combined"):
            saturating = 1.4 * self.mu * self.load / (1.5 * shear * c ** 3)
            self.entries["Contact/Spin"] = (
                saturating * self.scale(0.05, 3) * self.random.choice([-1, 1]))

    def draw_method(self):
        self.entries.update({
            "Mesh/Elements across patch": self.n, "Mesh/Growth": self.scale(*GROWTHS[self.dimension]),
            "Mesh/Patch offset": self.random.uniform(-0.5, 0.5),
            "Mesh/Rim levels": self.kind({f"rim levels {n}": w for n, w in RIM_LEVELS.items()})[-1],
            "Mesh/Adaptive levels": self.kind({f"levels {n}": w for n, w in ADAPTIVE_LEVELS.items()})[-1],
            "Contact/Slip operator": self.kind(OPERATORS), "Contact/Solver": self.kind(SOLVERS)})
        if "automatic" not in self.kinds:
            self.entries["Contact/Tolerance"] = self.scale(1e-6, 1e-2)
        self.approach = self.kind(PRESSED) == "approach"

    def curvature(self, radius):
        radii = (self.entries[f"{body}/{radius}"] for body in BOTH)
        return sum(1 / value for value in radii if value)

    def modulus(self):
        return 1 / sum((1 - self.entries[f"{body}/Poisson ratio"] ** 2)
                       / self.entries[f"{body}/Young modulus"]
                       for body in BOTH if self.entries.get(f"{body}/Rigid") != "true")

    def hertz(self):
        """Half-width (2D), or semi-axes in x and y after Hamrock and Brewe, m."""
        in_x = self.curvature("Radius")
        if self.dimension == 2:
            return [math.sqrt(4 * self.load / THICKNESS / (math.pi * self.modulus() * in_x))]
        flat, steep = sorted([in_x, self.curvature("Lateral radius")])
        ratio = 1.0339 * (steep / flat) ** 0.636
        short = (3 * (1 + 0.5968 * flat / steep) * self.load
                 / (math.pi * ratio * self.modulus() * (flat + steep))) ** (1 / 3)
        return [short, ratio * short] if in_x == steep else [ratio * short, short]


class ProfileScene(Scene):
    """A random wheel on a random rail: profiles, place of the wheelset, load, creepages."""

    def draw_profiles(self):
        track = self.random.choice
        self.entries.update({
            "Wheel/Lateral radius": 0, "Rail/Lateral radius": 0, "Rail/Radius": 0, "Rail/Shape": "block",
            "Rail/Block length": 0.3, "Rail/Block depth": 0.15, "Wheel/Width": 0.1, "Rail/Width": 0.1,
            "Wheel/Hub radius": 0.1, "Wheel/Radius": self.random.uniform(0.35, 0.5),
            "Profiles/Wheel profile": self.kind({"S1002": 3, "profiles/worn_wheel.txt": 1}),
            "Profiles/Rail profile": self.kind({"60E1": 3, "60E1 Manchester": 1}),
            "Profiles/Rail inclination": track(["1/40", "1/20"]), "Profiles/Side": track(["right", "left"]),
            "Profiles/Lateral shift": self.random.uniform(-7e-3, 7e-3),
            "Profiles/Yaw": self.random.uniform(-5e-3, 5e-3)})
        if self.kind({"plain": 4, "true sections": 1}) == "true sections":
            self.entries["Profiles/Body sections"] = "true"

    def draw_materials(self):
        pass

    def draw_load_and_depths(self):
        self.load = self.scale(1e4, 1e5)
        self.entries["Contact/Normal load"] = self.load

    def draw_roughness(self):
        pass

    def draw_creepages(self):
        self.mu = self.entries["Contact/Friction coefficient"] = self.scale(0.05, 0.6)
        if self.kind({"given": 3, "kinematics": 1}) == "kinematics":
            self.entries["Profiles/Creepages"] = "from kinematics"
            for entry in ("Creepage x", "Creepage y", "Spin"):
                self.entries[f"Contact/{entry}"] = 0
            return
        kind = self.kind(DIRECTIONS)
        angle = {"longitudinal": 0, "lateral": math.pi / 2}.get(kind, self.random.uniform(0, 6.28))
        size = 0 if kind == "spin" else self.scale(2e-4, 5e-3)
        self.entries["Contact/Creepage x"] = size * math.cos(angle)
        self.entries["Contact/Creepage y"] = size * math.sin(angle)
        self.entries["Contact/Spin"] = (
            self.scale(0.02, 1) * self.random.choice([-1, 1]) if kind in ("spin", "combined") else 0)

    def draw_method(self):
        self.entries.update({"Mesh/Elements across patch": self.n, "Mesh/Growth": 0.8,
                             "Mesh/Patch offset": self.random.uniform(-0.5, 0.5)})
        self.approach = False


def settings(entries):
    def text(value):
        return f"{value:.9g}" if isinstance(value, float) else str(value)
    return [word for name, value in entries.items() for word in ("--set", f"{name}={text(value)}")]
