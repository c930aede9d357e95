# Makes the files of this folder: yade -n -x bed.py (here by Yade 2023.02a)
# 36 spheres of two sizes and materials settle with friction on a floor between four walls; the floor has two facets.
import csv
from random import Random
from yade import export

light = O.materials.append(FrictMat(density=1200, young=5e6, poisson=0.3, frictionAngle=0.4, label='light'))
heavy = O.materials.append(FrictMat(density=7800, young=5e6, poisson=0.3, frictionAngle=0.4, label='heavy'))
side = 0.06
corner = [(-0.01, -0.01, 0), (side + 0.01, -0.01, 0), (side + 0.01, side + 0.01, 0), (-0.01, side + 0.01, 0)]
O.bodies.append([facet([corner[0], corner[1], corner[2]], material=light),
                 facet([corner[0], corner[2], corner[3]], material=light)])
for axis in range(2):
    for position, sense in ((0, 1), (side, -1)):
        O.bodies.append(wall(position, axis=axis, sense=sense, material=light))
random = Random(4711)
for k in range(36):
    i, j, layer = k % 3, k // 3 % 3, k // 9
    place = [0.02 * (i + 0.5), 0.02 * (j + 0.5), 0.012 + 0.02 * layer]
    place = [x + random.uniform(-5e-4, 5e-4) for x in place]
    is_heavy = random.random() < 0.4
    O.bodies.append(sphere(place, 0.00775 if is_heavy else 0.009, material=heavy if is_heavy else light))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                    [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(gravity=(0, 0, -9.8), damping=0.3),
]
O.dt = 0.3 * PWaveTimeStep()
O.run(60000, True)
export.text('bed.txt')
export.textExt('bed_material.txt', format='x_y_z_r_matId')
export.textExt('bed_id.txt', format='id_x_y_z_r_matId')
export.textExt('bed_attrs.txt', format='x_y_z_r_attrs', comment='vx vy vz mass',
               attrs=['b.state.vel', 'b.state.mass'])
exporter = export.VTKExporter('bed')
exporter.exportSpheres(what=dict(velocity='b.state.vel', id='b.id', materialId='b.material.id', mass='b.state.mass'))
spheres = [b.id for b in O.bodies if isinstance(b.shape, Sphere)]
exporter.exportInteractions(what=dict(forceN='i.phys.normalForce.norm()', normalForce='i.phys.normalForce',
                                      shearForce='i.phys.shearForce'))

with open('particles.csv', 'w', newline='') as file:
    rows = csv.writer(file)
    rows.writerow('id material x y z radius mass vx vy vz wx wy wz fx fy fz'.split())
    for k in spheres:
        b = O.bodies[k]
        rows.writerow([k, b.material.id] + [repr(float(v)) for v in (*b.state.pos, b.shape.radius, b.state.mass, *b.state.vel,
                                                               *b.state.angVel, *O.forces.f(k))])
with open('contacts.csv', 'w', newline='') as file:
    rows = csv.writer(file)
    rows.writerow('id1 id2 overlap nx ny nz fx fy fz ftx fty ftz'.split())
    for i in O.interactions:  # normal from the first to the second, forces on the second
        if not i.isReal:
            continue
        rows.writerow([i.id1, i.id2] + [repr(float(v)) for v in (i.geom.penetrationDepth, *i.geom.normal,
                                                           *i.phys.normalForce, *i.phys.shearForce)])

# Last: Yade 2023.02a writes a further file bed-intrs_60000_0.vtp, without end, and breaks off.
VTKRecorder(fileName='bed-', recorders=['spheres', 'velocity', 'id', 'mass', 'materialId', 'force', 'intr'],
            compress=False)()
