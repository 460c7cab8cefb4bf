// The meshes of a stock surface, one for each tile; updated where the surface has changed.

import { type ShaderMaterial, BufferAttribute, BufferGeometry, Group, Mesh } from "three";
import { type TileEdges, ADJACENT_TILES, noEdges, triangles } from "./facets";
import type { StockSurface } from "./surface";
import { TILE_CORNERS, TILE_CELLS } from "./tile";

interface TileMesh {
  mesh: Mesh<BufferGeometry, ShaderMaterial>;
  /** Lowest and highest corner, mm from the top of the stock. */
  heights: [number, number];
  triangles: number;
  /** Which corners on its edges are corners of squares. */
  edges: TileEdges;
  /** The corners of an adjacent tile on a shared edge have changed. */
  hasStaleEdges: boolean;
}

export class TileMeshes {
  readonly group = new Group();
  /** The indices of all tiles. */
  readonly all: number[];
  private parts: TileMesh[] = [];

  constructor(readonly surface: StockSurface, material: ShaderMaterial) {
    for (let tile = 0; tile < surface.stale.length; tile++) {
      const [x, y] = surface.firstCorner(tile);
      const gridCorners = new Uint16Array(2 * TILE_CORNERS * TILE_CORNERS);
      for (let n = 0; n < TILE_CORNERS * TILE_CORNERS; n++) gridCorners.set([x + (n % TILE_CORNERS), y + Math.floor(n / TILE_CORNERS)], 2 * n);
      const mesh = new Mesh(tileGeometry(gridCorners, surface), material);
      mesh.frustumCulled = false;
      this.group.add(mesh);
      this.parts.push({ mesh, heights: [surface.bottom, 0], triangles: 0, edges: noEdges(), hasStaleEdges: false });
    }
    surface.stale.fill(1);
    this.all = [...surface.stale.keys()];
  }

  get count(): number {
    return this.parts.length;
  }

  /** Number of triangles of a tile, as of its last update. */
  triangles(tile: number): number {
    return this.parts[tile]!.triangles;
  }

  /** Lowest and highest corner of a tile, as of its last update, mm from the top of the stock. */
  heights(tile: number): [number, number] {
    return this.parts[tile]!.heights;
  }

  /** Updates the mesh of a tile where it has changed; until the adjacent tiles are updated, their edges may differ. */
  update(tile: number): void {
    const { surface } = this;
    const part = this.parts[tile]!;
    if (!surface.stale[tile] && !part.hasStaleEdges) return;
    const { attributes, index } = part.mesh.geometry;
    const corners = {
      z: attributes.z!.array as Float32Array,
      slot: attributes.slot!.array as Uint8Array,
      target: attributes.target?.array as Float32Array | undefined,
      shift: attributes.shift?.array as Int8Array | undefined,
    };
    if (surface.stale[tile]) {
      part.heights = surface.copy(tile, corners);
      surface.downhill(tile, attributes.lean!.array as Int8Array);
      for (const attribute of [attributes.z, attributes.slot, attributes.lean, attributes.target, attributes.shift]) if (attribute) attribute.needsUpdate = true;
    }
    surface.stale[tile] = 0;
    part.hasStaleEdges = false;
    const [x, y] = surface.firstCorner(tile);
    const open: [number, number] = [(surface.open.column ?? -1) - x, (surface.open.row ?? -1) - y];
    const own = noEdges();
    const count = triangles(corners, index!.array as Uint16Array, surface.bottom, open, { own, neighbors: this.neighborEdges(tile) });
    this.markNeighbors(tile, part.edges, own);
    part.edges = own;
    part.triangles = count / 3;
    part.mesh.geometry.setDrawRange(0, count);
    index!.clearUpdateRanges();
    index!.addUpdateRange(0, count);
    index!.needsUpdate = true;
  }

  /** Which corners on the edges of a tile are corners of squares of adjacent tiles. */
  private neighborEdges(tile: number): TileEdges {
    const all = noEdges();
    ADJACENT_TILES.forEach(([, , sharedEdge], edge) => {
      const other = this.neighbor(tile, edge);
      if (other) all.set(other.edges.subarray(sharedEdge * TILE_CORNERS, (sharedEdge + 1) * TILE_CORNERS), edge * TILE_CORNERS);
    });
    return all;
  }

  /** Marks the adjacent tiles on whose shared edges corners have changed. */
  private markNeighbors(tile: number, before: TileEdges, after: TileEdges): void {
    for (let edge = 0; edge < ADJACENT_TILES.length; edge++) {
      const other = this.neighbor(tile, edge);
      for (let n = edge * TILE_CORNERS; other && n < (edge + 1) * TILE_CORNERS; n++) if (before[n] !== after[n]) other.hasStaleEdges = true;
    }
  }

  private neighbor(tile: number, edge: number): TileMesh | undefined {
    const [nx, ny] = this.surface.tiles;
    const [dx, dy] = ADJACENT_TILES[edge]!;
    const [x, y] = [(tile % nx) + dx, Math.floor(tile / nx) + dy];
    return x >= 0 && y >= 0 && x < nx && y < ny ? this.parts[y * nx + x] : undefined;
  }

  /** Makes only these tiles visible, updated; returns the number of their triangles. */
  choose(tiles: readonly number[]): number {
    for (const { mesh } of this.parts) mesh.visible = false;
    let sum = 0;
    for (const tile of tiles) this.update(tile);
    for (const tile of tiles) {
      // Again, where a later tile has changed the corners on the shared edge.
      this.update(tile);
      const { mesh, triangles } = this.parts[tile]!;
      mesh.visible = triangles > 0;
      sum += triangles;
    }
    return sum;
  }

  dispose(): void {
    for (const { mesh } of this.parts) mesh.geometry.dispose();
  }
}

function tileGeometry(gridCorners: Uint16Array, { target, shift }: StockSurface): BufferGeometry {
  const count = gridCorners.length / 2;
  const geometry = new BufferGeometry();
  geometry.setAttribute("at", new BufferAttribute(gridCorners, 2));
  geometry.setAttribute("z", new BufferAttribute(new Float32Array(count), 1));
  geometry.setAttribute("slot", new BufferAttribute(new Uint8Array(count), 1));
  geometry.setAttribute("lean", new BufferAttribute(new Int8Array(2 * count), 2, true));
  if (target) geometry.setAttribute("target", new BufferAttribute(new Float32Array(count), 1));
  if (shift) geometry.setAttribute("shift", new BufferAttribute(new Int8Array(2 * count), 2, true));
  geometry.setIndex(new BufferAttribute(new Uint16Array(6 * TILE_CELLS * TILE_CELLS), 1));
  return geometry;
}
