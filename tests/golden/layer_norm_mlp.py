#!/usr/bin/env python3
"""Prints layer_norm_mlp.txt: a tiny perceptron with LayerNorm, from an implementation of its own.

    python3 tests/golden/layer_norm_mlp.py > tests/golden/layer_norm_mlp.txt      (needs numpy)

Nothing here is derived by hand: the gradient is the complex-step derivative of the forward pass
(Squire & Trapp 1998), exact to rounding, and Adam is written as in Kingma & Ba 2015, Algorithm 1.
Each line: a name, the number of values, the values (row-major).
"""
import numpy as np

INPUTS, HIDDEN, OUTPUTS, BATCH = 5, (7, 6), 3, 4
DELTA, LEARNING_RATE, STEPS = 0.5, 0.01, 3


def blocks():
    sizes = [INPUTS, *HIDDEN, OUTPUTS]
    for i, (rows, cols) in enumerate(zip(sizes, sizes[1:])):
        yield (rows, cols)
        yield (cols,)
        if i < len(HIDDEN):
            yield (cols,)
            yield (cols,)


def split(theta):
    at = 0
    for shape in blocks():
        size = int(np.prod(shape))
        yield theta[at:at + size].reshape(shape)
        at += size
    assert at == theta.size


def forward(theta, x):
    parts = split(theta)
    h = x
    for _ in HIDDEN:
        w, b, gain, shift = (next(parts) for _ in range(4))
        z = h @ w + b
        mean = z.sum(axis=1, keepdims=True) / z.shape[1]
        variance = ((z - mean) ** 2).sum(axis=1, keepdims=True) / z.shape[1]
        z = gain * (z - mean) / np.sqrt(variance + 1e-5) + shift
        h = np.where(z.real > 0, z, 0)
    w, b = next(parts), next(parts)
    return h @ w + b


def loss(theta, x, target):
    e = forward(theta, x) - target
    size = np.where(e.real < 0, -e, e)
    return np.where(size.real <= DELTA, e * e / 2, DELTA * (size - DELTA / 2)).sum() / BATCH


def gradient(theta, x, target):
    step = 1e-30
    result = np.empty_like(theta)
    for i in range(theta.size):
        moved = theta.astype(complex)
        moved[i] += 1j * step
        result[i] = loss(moved, x, target).imag / step
    return result


def show(name, values):
    values = np.ravel(values)
    print(name, values.size, *(repr(float(v)) for v in values))


def main():
    random = np.random.default_rng(20240229)
    theta = random.normal(size=sum(int(np.prod(s)) for s in blocks())) * 0.6
    x = random.normal(size=(BATCH, INPUTS))
    target = random.normal(size=(BATCH, OUTPUTS))
    show("sizes", [INPUTS, *HIDDEN, OUTPUTS])
    show("delta", DELTA)
    show("learning_rate", LEARNING_RATE)
    show("x", x)
    show("target", target)
    show("parameters", theta)
    show("output", forward(theta, x))
    show("loss", loss(theta, x, target))
    show("gradient", gradient(theta, x, target))
    m, v = np.zeros_like(theta), np.zeros_like(theta)
    for t in range(1, STEPS + 1):
        g = gradient(theta, x, target)
        m = 0.9 * m + 0.1 * g
        v = 0.999 * v + 0.001 * g * g
        theta = theta - LEARNING_RATE * (m / (1 - 0.9**t)) / (np.sqrt(v / (1 - 0.999**t)) + 1e-8)
        show(f"parameters_after_{t}", theta)


main()
