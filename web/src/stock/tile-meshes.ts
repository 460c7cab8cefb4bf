// The surface of a stock as meshes, one for each tile: made again where it has changed.

import { type ShaderMaterial, BufferAttribute, BufferGeometry, Group, Mesh } from "three";
import { type TileEdges, ADJACENT_TILES, noEdges, triangles } from "./facets";
import type { StockSurface } from "./surface";
import { TILE_CORNERS, TILE_CELLS } from "./tile";

interface TileMesh {
  mesh: Mesh<BufferGeometry, ShaderMaterial>;
  /** Lowest and highest corner, from the top, mm. */
  ends: [number, number];
  triangles: number;
  /** The corners that its squares have on its edges. */
  edges: TileEdges;
  /** Those of an adjacent tile have changed. */
  hasStaleEdges: boolean;
}

export class TileMeshes {
  readonly group = new Group();
  /** The numbers of all tiles. */
  readonly all: number[];
  private parts: TileMesh[] = [];

  constructor(readonly surface: StockSurface, material: ShaderMaterial) {
    for (let tile = 0; tile < surface.stale.length; tile++) {
      const [x, y] = surface.firstCorner(tile);
      const places = new Uint16Array(2 * TILE_CORNERS * TILE_CORNERS);
      for (let at = 0; at < TILE_CORNERS * TILE_CORNERS; at++) places.set([x + (at % TILE_CORNERS), y + Math.floor(at / TILE_CORNERS)], 2 * at);
      const mesh = new Mesh(geometryOf(places, surface), material);
      mesh.frustumCulled = false;
      this.group.add(mesh);
      this.parts.push({ mesh, ends: [surface.bottom, 0], triangles: 0, edges: noEdges(), hasStaleEdges: false });
    }
    surface.stale.fill(1);
    this.all = [...surface.stale.keys()];
  }

  get count(): number {
    return this.parts.length;
  }

  /** Triangles of a tile as it was taken last. */
  triangles(tile: number): number {
    return this.parts[tile]!.triangles;
  }

  /** Its lowest and highest corner as it was taken last, from the top, mm. */
  ends(tile: number): [number, number] {
    return this.parts[tile]!.ends;
  }

  /** Uploads what has changed of a tile; its edges may then differ from those of adjacent tiles until these are uploaded. */
  take(tile: number): void {
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
      part.ends = surface.copy(tile, corners);
      surface.falls(tile, attributes.lean!.array as Int8Array);
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

  /** The corners that the adjacent tiles have on its edges. */
  private neighborEdges(tile: number): TileEdges {
    const all = noEdges();
    ADJACENT_TILES.forEach(([, , same], edge) => {
      const other = this.beyond(tile, edge);
      if (other) all.set(other.edges.subarray(same * TILE_CORNERS, (same + 1) * TILE_CORNERS), edge * TILE_CORNERS);
    });
    return all;
  }

  private markNeighbors(tile: number, before: TileEdges, after: TileEdges): void {
    for (let edge = 0; edge < ADJACENT_TILES.length; edge++) {
      const other = this.beyond(tile, edge);
      for (let at = edge * TILE_CORNERS; other && at < (edge + 1) * TILE_CORNERS; at++) if (before[at] !== after[at]) other.hasStaleEdges = true;
    }
  }

  private beyond(tile: number, edge: number): TileMesh | undefined {
    const [across, up] = this.surface.tiles;
    const [dx, dy] = ADJACENT_TILES[edge]!;
    const [x, y] = [(tile % across) + dx, Math.floor(tile / across) + dy];
    return x >= 0 && y >= 0 && x < across && y < up ? this.parts[y * across + x] : undefined;
  }

  /** Draws only these tiles, in their present state; returns the number of their triangles. */
  choose(tiles: readonly number[]): number {
    for (const { mesh } of this.parts) mesh.visible = false;
    let sum = 0;
    for (const tile of tiles) this.take(tile);
    for (const tile of tiles) {
      // Once more where a later one has other corners on their edge.
      this.take(tile);
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

function geometryOf(places: Uint16Array, { target, shift }: StockSurface): BufferGeometry {
  const count = places.length / 2;
  const geometry = new BufferGeometry();
  geometry.setAttribute("at", new BufferAttribute(places, 2));
  geometry.setAttribute("z", new BufferAttribute(new Float32Array(count), 1));
  geometry.setAttribute("slot", new BufferAttribute(new Uint8Array(count), 1));
  geometry.setAttribute("lean", new BufferAttribute(new Int8Array(2 * count), 2, true));
  if (target) geometry.setAttribute("target", new BufferAttribute(new Float32Array(count), 1));
  if (shift) geometry.setAttribute("shift", new BufferAttribute(new Int8Array(2 * count), 2, true));
  geometry.setIndex(new BufferAttribute(new Uint16Array(6 * TILE_CELLS * TILE_CELLS), 1));
  return geometry;
}
