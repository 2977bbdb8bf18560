import type { Picked } from '@/uploads'

import type { FolderAsk } from './api'

export type GameProject = NonNullable<FolderAsk['project']>

const MOST_BYTES = 64 * 2 ** 20
const HOLDER = /\.(unity|prefab|asset|playable|controller)$/
const HOLDER_OR_META =
  /\.(unity|prefab|asset|playable|controller|mixer)(\.meta)?$|\.(wav|ogg|mp3|aiff?|flac|opus)\.meta$/
const SETTINGS = new Set(['ProjectSettings/AudioManager.asset', 'ProjectSettings/ProjectVersion.txt'])
const SKIPPED = /(^|\/)(Library|Temp|Logs|obj|node_modules|\.[^/]*)\//
const NAMES_SOUNDS = /AudioSource|8300000|PrefabInstance|AudioRandomContainer/
const VERSION = 'ProjectSettings/ProjectVersion.txt'

export class ProjectTooLarge extends Error {}

interface Found {
  /** The project's file from its root; empty for Unity. */
  path: string
  root: string
  isWanted: (path: string) => boolean
}

/** The project of a middleware or an engine among dropped files; null where there is none. */
export function projectIn(picked: readonly Picked[]): Found | null {
  const paths = picked.map(({ path }) => path).filter((path) => !SKIPPED.test(path))
  const isUnreal = paths.length === 1 && paths[0]?.endsWith('.json')
  const marks = paths.filter(
    (path) => isUnreal || /(\.wproj|\.fspro|\/ProjectVersion\.txt|(^|\/)project\.godot)$/.test(path),
  )
  const depth = (path: string) => path.replace(VERSION, '').split('/').length
  const [mark] = marks.sort((a, b) => depth(a) - depth(b) || a.localeCompare(b))
  if (mark === undefined) return null
  if (mark.endsWith(VERSION)) {
    const isWanted = (path: string) => SETTINGS.has(path) || HOLDER_OR_META.test(path)
    return { path: '', root: mark.slice(0, -VERSION.length), isWanted }
  }
  const root = mark.slice(0, mark.lastIndexOf('/') + 1)
  return { path: mark.slice(root.length), root, isWanted: wantedBy(mark.slice(root.length)) }
}

function wantedBy(name: string): (path: string) => boolean {
  if (name.endsWith('.wproj')) return (path) => path === name || path.endsWith('.wwu')
  if (name.endsWith('.fspro')) return (path) => path === name || /^Metadata\/.*\.xml$/.test(path)
  if (name.endsWith('.json')) return (path) => path === name
  return (path) => path === name || /\.(import|tscn|tres|gd|cs)$/.test(path)
}

/** A project's texts as the server reads them: a gzip of JSON, in base64. */
export async function packProject(
  picked: readonly Picked[],
  { path: name, root, isWanted }: Found,
): Promise<GameProject> {
  const texts: Record<string, string> = {}
  let bytes = 0
  for (const { file, path: whole } of picked) {
    const path = whole.slice(root.length)
    if (!whole.startsWith(root) || SKIPPED.test(whole) || !isWanted(path)) continue
    const text = new TextDecoder().decode(await file.arrayBuffer())
    if (name === '' && HOLDER.test(path) && !NAMES_SOUNDS.test(text)) continue
    bytes += file.size
    if (bytes > MOST_BYTES)
      throw new ProjectTooLarge('The project’s texts have more than 64 MiB. Choose the sounds without it.')
    texts[path] = text
  }
  return { path: name, content_base64: base64(await gzip(JSON.stringify(texts))) }
}

async function gzip(text: string): Promise<Uint8Array> {
  const packing = new CompressionStream('gzip')
  const writer = packing.writable.getWriter()
  void writer.write(new TextEncoder().encode(text)).then(() => writer.close())
  return new Uint8Array(await new Response(packing.readable).arrayBuffer())
}

function base64(bytes: Uint8Array): string {
  let text = ''
  for (let at = 0; at < bytes.length; at += 0x8000) text += String.fromCharCode(...bytes.subarray(at, at + 0x8000))
  return btoa(text)
}
