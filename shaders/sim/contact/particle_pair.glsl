// A pair of particles in an iteration: balls, or boxes with flat faces, that push each other at their centres.

/// @param pressed the last normal impulse, which does not matter here.
Contact pairNow(Pair pair, ContactSides sides, inout Arm armA, inout Arm armB, float pressed)
{
    MoverPoint a = moverPoint(sides.movers.x, armA.r), b = moverPoint(sides.movers.y, armB.r);
    vec3 startDifference = a.centre - b.centre + (a.arm - b.arm);
    Contact contact;
    vec2 excess = radiusExcess(sides.movers);
    contact.touch = sim.diameter + (excess.x + excess.y);
    contact.slide = a.move - b.move;
    vec3 difference = startDifference + contact.slide;
    float apart = length(difference);
    Separation start = separationOf(startDifference, sides.exit, fetchRotation(sides.movers.x),
                                    fetchRotation(sides.movers.y), sides.hidden, contact.touch);
    contact.normal = start.keepsNormal ? start.normal : contactNormal(difference, apart);
    contact.sameAssembly = sides.exit.sameAssembly;
    setKind(contact, excess);
    contact.leaving = max(dot(a.move, contact.normal), -dot(b.move, contact.normal));
    contact.startGap = (start.oneSided && sides.exit.deepInside ? 0.0 : start.distance) - contact.touch;
    contact.gap = start.keepsNormal ? contact.startGap + dot(contact.slide, start.normal) : apart - contact.touch;
    setMasses(contact, sides, armA, armB, vec2(a.splits, b.splits));
    return contact;
}
