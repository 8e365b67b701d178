// Nearby light along wi of so many columns, spread over the light's samples of the pixel by `turn`, 0 to 1. far: distance of
// the light, in the asset's space.
fn nearby_of(wi: vec3f, far: f32, columns: f32, turn: f32) -> vec4f {
    var sum = vec3f(0.0);
    for (var number = 0.0; number < columns; number += 1.0) {
        let place = (number + fract(12.9898 * turn + 0.7548777 * number)) / columns;
        let angle = fract(turn + number * 0.61803399);
        sum += nearby_light(1u, LENGTHS, vertex.x, wi, far, vec2f(place, angle));
    }
    return vec4f(sum / columns, 1.0);
}
