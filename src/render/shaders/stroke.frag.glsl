// A stroke: covered up to its radius from the line, or, as a ring, in a band within its radius.

in vec2 v_point;
flat in float v_half;
flat in vec3 v_shape;
flat in vec4 v_color;

out vec4 o_color;

// How much of a pixel a dash covers, at this place along the line.
float dash(float along, float period)
{
    float from_middle = abs(fract(along / (2.0 * period)) - 0.5) * 2.0 * period;
    return clamp(0.5 * period - from_middle + 0.5, 0.0, 1.0);
}

void main()
{
    vec2 nearest = vec2(clamp(v_point.x, -v_half, v_half), 0.0);
    float depth = v_shape.x - distance(v_point, nearest);
    float covered = clamp(depth + 0.5, 0.0, 1.0);
    float place = v_point.x + v_half;
    if (v_shape.y > 0.0) {
        covered *= clamp(v_shape.y - depth + 0.5, 0.0, 1.0);
        place = (atan(v_point.y, v_point.x) + 3.14159265) * v_shape.x;
    }
    if (v_shape.z > 0.0)
        covered *= dash(place, v_shape.z);
    float alpha = v_color.a * covered;
    o_color = vec4(v_color.rgb * alpha, alpha);
}
