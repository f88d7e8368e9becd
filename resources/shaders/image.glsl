// SPDX-License-Identifier: GPL-3.0-or-later
// Where vertices are in the picture (VolumeView).
uniform bool perspective;
uniform vec3 originHigh;      // the eye, or what an orthographic camera looks at, from the mesh's origin, in two floats
uniform vec3 originLow;
uniform mat3 imageFromWorld;  // VolumeView, without the shift
uniform vec3 imageOfOrigin;
uniform vec2 smallestValue;   // high and low part
uniform float perValue;
uniform vec2 pictureSize;     // in samples, of the part that is drawn
uniform vec2 pictureCentre;   // of the whole picture, in samples from the part's upper left corner
uniform vec2 sampleShift;     // of samples from the middle, right and down
uniform float nearest;

// Image and scaled value of a vertex, which is a place and a value.
vec4 imageOf(vec4 vertex)
{
    vec3 image = imageFromWorld * ((vertex.xyz - originHigh) - originLow) + imageOfOrigin;
    return vec4(image, clamp(((vertex.w - smallestValue.x) - smallestValue.y) * perValue, -1e25, 1e25));
}

vec4 clipPositionOf(vec3 image)
{
    float along = perspective ? image.z : 1.0;
    vec2 place = (image.xy + (pictureCentre - pictureSize * 0.5 - sampleShift) * along) * 2.0 / pictureSize;
    return vec4(place.x, -place.y, perspective ? image.z - 2.0 * nearest : 0.0, along);
}
