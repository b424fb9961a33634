#!/usr/bin/env python3
"""A painting's picture as a function of PyTorch, through which it can propagate back.

    torch_function.py
"""

import sys

import numpy as np
import suffuse

try:
    import torch
except ImportError:
    print("skipped: PyTorch is not installed (python3-torch)")
    sys.exit(77)


class Picture(torch.autograd.Function):
    """From colours (segments, 3) and densities (segments) to a picture (height, width, 3)."""

    @staticmethod
    def forward(context, colours, densities, painting, size):
        """Draws the painting with other colours and densities."""
        segments = painting.segments.copy()
        segments["colour"][:, :3] = colours.detach().numpy()
        segments["density"] = densities.detach().numpy()
        context.drawn = suffuse.DifferentiablePicture(painting.replaced(segments=segments), size=size)
        return torch.from_numpy(context.drawn.picture.copy())

    @staticmethod
    def backward(context, by_picture):
        """Gives the derivatives by colours and densities."""
        slopes = context.drawn.backward(by_picture.numpy())["segments"]
        as_tensor = lambda name: torch.from_numpy(np.ascontiguousarray(slopes[name], dtype=np.float32))
        return as_tensor("ryb"), as_tensor("density"), None, None


if __name__ == "__main__":
    segments = suffuse.new_table("segments", 2)
    segments["bezier"] = [(10, 10), (30, 40), (40, 0), (54, 30)]
    segments["bezier"][1, :, 1] += 8
    segments["stroke"] = [0, 1]
    painting = suffuse.Painting(64, 48).replaced(segments=segments, strokes={"id": [1, 2]})
    colours = torch.full((2, 3), 0.5, requires_grad=True)
    densities = torch.full((2,), 7.0, requires_grad=True)
    optimizer = torch.optim.Adam([colours], lr=0.05)
    losses = []
    for _ in range(20):
        optimizer.zero_grad()
        loss = ((Picture.apply(colours.clamp(0, 1), densities, painting, 96) - torch.tensor([0.9, 0.8, 0.3])) ** 2).mean()
        loss.backward()
        optimizer.step()
        losses.append(float(loss))
    print(f"loss {losses[0]:.4f} → {losses[-1]:.4f}")
    if not losses[-1] < losses[0]:
        sys.exit("the loss did not fall as it should")
