
import re
from math import atan, cos, pi, sin
from time import perf_counter

kinds = [
    O.materials.append(FrictMat(density=density, young=young, poisson=poisson, frictionAngle=0.0))
    for density, young, poisson in materials
]
grains = []
for line in open("grains.txt"):
    kind, radius, frozen, *numbers = line.split()
    x, y, z, vx, vy, vz, wx, wy, wz = map(float, numbers)
    number = O.bodies.append(
        sphere((x, y, z), float(radius), fixed=frozen == "1", material=O.materials[kinds[int(kind)]])
    )
    O.bodies[number].state.vel = (vx, vy, vz)
    O.bodies[number].state.angVel = (wx, wy, wz)
    grains.append(number)


def pieces(wall):
    material = O.materials[kinds[wall["material"]]]
    if "axis" in wall:
        return [O.bodies.append(utils.wall(wall["position"], axis=wall["axis"], material=material))]
    vertices = [tuple(map(float, words)) for words in re.findall(r"vertex (\S+) (\S+) (\S+)", open(wall["file"]).read())]
    return [O.bodies.append(facet(vertices[k : k + 3], material=material)) for k in range(0, len(vertices), 3)]


surfaces = [pieces(wall) for wall in walls]
motions = []
for ids, wall in zip(surfaces, walls):
    motion = wall["motion"]
    if motion[0] == "translation":
        axis, speed = motion[1:]
        motions.append(TranslationEngine(ids=ids, translationAxis=axis, velocity=speed))
    elif motion[0] == "rotation":
        point, axis, rate = motion[1:]
        motions.append(
            RotationEngine(ids=ids, rotateAroundZero=True, zeroPoint=point, rotationAxis=axis, angularVelocity=rate)
        )


oscillates = any(wall["motion"][0] == "oscillation" for wall in walls)


def oscillate():
    # The leap that this step makes ends half a step after the next whole one.
    time = (O.iter + 1) * step
    for ids, wall in zip(surfaces, walls):
        motion = wall["motion"]
        if motion[0] == "oscillation":
            amplitude, frequency = motion[1:]
            leap = sin(2 * pi * frequency * (time + step / 2)) - sin(2 * pi * frequency * (time - step / 2))
            for number in ids:
                O.bodies[number].state.vel = Vector3(*amplitude) * (leap / step)


def of_pairs(table):
    return MatchMaker(matches=[(kinds[a], kinds[b], value) for a, b, value in table])


O.periodic = period is not None
if period:
    O.cell.hSize = Matrix3(period[0], 0, 0, 0, period[1], 0, 0, 0, period[2])

O.dt = step
O.engines = (
    [
        ForceResetter(),
        InsertionSortCollider(
            [Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Facet_Aabb()], verletDist=skin, allowBiggerThanPeriod=True
        ),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(hertzian=True), Ig2_Facet_Sphere_ScGeom(hertzian=True)],
            [
                Ip2_FrictMat_FrictMat_MindlinPhys(
                    en=of_pairs(restitution),
                    es=of_pairs(restitution),
                    frictAngle=of_pairs([(a, b, atan(mu)) for a, b, mu in friction]),
                )
            ],
            [Law2_ScGeom_MindlinPhys_Mindlin()],
        ),
    ]
    + ([] if is_timed else [PyRunner(command="watch()", iterPeriod=1, initRun=True)])
    + motions
    + ([PyRunner(command="oscillate()", iterPeriod=1, initRun=True)] if oscillates else [])
    + [NewtonIntegrator(gravity=gravity, damping=0)]
)

# Forces on walls are looked at so often between two samples.
glances = max(1, steps_per_sample // 50)
forces = [Vector3(0, 0, 0) for _ in walls]
looks = 0


def watch():
    global looks
    if O.iter % glances:
        return
    looks += 1
    for k, ids in enumerate(surfaces):
        for number in ids:
            forces[k] += O.forces.f(number)


def has_left(place):
    return limits and any(x < low or x > high for x, low, high in zip(place, *limits))


def sample(means, on_walls):
    global looks, forces
    count, place, energy = 0, Vector3(0, 0, 0), 0.0
    for number in grains:
        body = O.bodies[number]
        if body is None:
            continue
        state = body.state
        # Places are half a step ahead.
        centre = state.pos - state.vel * (0.5 * step)
        if has_left(centre):
            O.bodies.erase(number)
            continue
        count += 1
        place += centre
        if not state.blockedDOFs:
            energy += 0.5 * state.mass * state.vel.squaredNorm() + 0.5 * state.inertia[0] * state.angVel.squaredNorm()
    place /= max(count, 1)
    print(O.iter, count, *place, energy, file=means)
    if on_walls:
        print(O.iter, *(force[axis] / max(looks, 1) for force in forces for axis in range(3)), file=on_walls)
    looks, forces = 0, [Vector3(0, 0, 0) for _ in walls]


if is_timed:
    # The first steps find all neighbours.
    O.run(2, True)
    start = perf_counter()
    O.run(samples * steps_per_sample, True)
    print("Loop time of", perf_counter() - start, "s")
else:
    with open("means.txt", "w") as means, open("walls.txt", "w") as on_walls:
        for _ in range(samples):
            O.run(steps_per_sample, True)
            sample(means, on_walls if walls else None)
