// Every construct that lowering f64 to integers has to change. Each invocation reads an item, and writes 16 numbers.
//
// A test compares the results with those of lavapipe's f64. Lavapipe changes the order of sums that have a constant,
// and of a sum with fract, so the numbers that are compared have no such sum.

struct Inner {
    @align(16) small: f32,
    vector: vec3<f64>,
    after: f64,
}

struct Item {
    triple: vec3<f64>,
    close: f64,
    list: array<vec3<f64>, 3>,
    inner: Inner,
    pair: vec2<f64>,
    quad: vec4<f64>,
    tail: vec3<f64>,
    number: u32,
    @size(24) wide: f64,
    last: i32,
}

const TENTH: f64 = 0.1lf;
const TABLE = array<vec3<f64>, 2>(vec3<f64>(1.0lf, -2.0lf, 3.5lf), vec3<f64>(TENTH));

// The names end with digits, and are those of arguments too. Programs know the overrides by them.
override scale2: f32 = 2.5;
override n: u32 = 3u;
override flag: bool = true;

var<private> counter: vec4<f64> = vec4<f64>(1.0lf, 2.0lf, TENTH, 4.0lf);
var<workgroup> shared_rows: array<vec3<f64>, 64>;

@group(0) @binding(0) var<storage, read> items: array<Item>;
@group(0) @binding(1) var<storage, read_write> results: array<f64>;
@group(0) @binding(2) var<storage, read_write> copies: array<Item>;

fn put(place: ptr<function, vec3<f64>>, index: i32, n: f64) {
    (*place)[index] = n;
    (*place).y += n;
}

fn add_to(sum: ptr<function, f64>, n: f64) -> bool {
    *sum = *sum + n;
    return *sum > n;
}

fn turned(a: f64, b: vec3<f64>) -> vec3<f64> {
    var result = b * a;
    put(&result, 1, a);
    return result.zyx * vec3<f64>(result.xy, 1.0lf);
}

fn copied(item: Item) -> Item {
    var copy = item;
    copy.inner.vector = copy.inner.vector.yzx;
    copy.list[1].z = copy.close;
    return copy;
}

fn looped(start: vec3<f64>, rows: array<vec3<f64>, 2>) -> vec3<f64> {
    var x = start;
    var all_rows = rows;
    for (var k = 0; k < 6; k++) {
        if x.x < f64(k) {
            x += turned(f64(scale2), all_rows[k % 2]);
            continue;
        }
        switch k {
            case 1, 2: {
                x = -x;
            }
            case 3: {
                x /= vec3<f64>(3.0lf, 7.0lf, 0.3lf);
            }
            default: {
                x *= 1.5lf;
            }
        }
        if x.y > 1e30lf {
            break;
        }
    }
    var left = 3u;
    loop {
        x /= TABLE[left % 2u] + start;
        continuing {
            left -= 1u;
            break if left == 0u || x.z > 1e20lf;
        }
    }
    return x;
}

@compute @workgroup_size(64)
fn every2(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let i = min(id.x, arrayLength(&items) - 1u);
    let item = items[i];
    var x = items[i].triple;
    x[i % 3u] = item.close;
    var rows = array<vec3<f64>, 2>(x, items[i].list[i % 3u]);
    rows[i % 2u].x = items[i].list[i % 3u][i % 3u];
    rows[1][i % 3u] += item.wide;
    shared_rows[local] = rows[i % 2u];
    workgroupBarrier();
    let neighbour = shared_rows[(local + 1u) % 64u];
    let walked = looped(x, rows);
    var sum: f64;
    let grew = add_to(&sum, item.tail.y);
    copies[i] = copied(item);
    copies[i].tail[i % 3u] = sum;
    copies[i].quad = vec4<f64>(item.pair, item.pair.yx);
    let place = &copies[i].list[2];
    *place = item.inner.vector;
    (*place).y = item.inner.after;
    counter.w -= item.quad.w;
    counter[i % 4u] += TENTH;
    let below = item.triple < item.tail;
    let first = i * 16u;
    results[first] = walked.x;
    results[first + 1u] = walked.y + walked.z;
    results[first + 2u] = neighbour.x + neighbour.y + neighbour.z;
    results[first + 3u] = counter.x + counter.y + counter.z + counter.w;
    results[first + 4u] = copies[i].tail.x + copies[i].tail.y + copies[i].tail.z;
    results[first + 5u] = copies[i].list[1].z + copies[i].list[2].y - copies[i].list[2].z;
    results[first + 6u] = copies[i].inner.vector.x + f64(copies[i].inner.small) + copies[i].inner.after;
    results[first + 7u] = dot(copies[i].quad, item.quad) + copies[i].wide + f64(copies[i].last);
    results[first + 8u] = select(select(f64(scale2), TENTH, grew), f64(n), flag && below.x);
    results[first + 9u] = f64(f32(item.close)) + f64(i32(item.tail.x)) + f64(u32(abs(item.tail.z))) + f64(all(below));
    let chosen = select(item.triple, item.tail, below);
    results[first + 10u] = length(chosen) + normalize(item.quad).z;
    results[first + 11u] = max(cross(item.triple, item.quad.xyz).y, floor(item.close)) * fract(item.wide);
    let negative = -item.quad.wzyx;
    results[first + 12u] = max(negative.x, min(negative.y, negative[item.number % 4u]));
    results[first + 13u] = clamp(item.close, -1.0lf, f64(scale2)) * sign(item.wide) + ceil(item.pair.x) - trunc(item.pair.y);
    results[first + 14u] = f64(vec2<f32>(item.pair).x) + vec2<f64>(vec2<i32>(item.last, 3)).x + vec3<f64>(x.xy, item.wide).z;
    results[first + 15u] = f64(item.number) * f64(item.last) + TABLE[item.number % 2u].y;
}
