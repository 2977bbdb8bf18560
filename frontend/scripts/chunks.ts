interface ModuleGraph {
  getModuleInfo: (id: string) => { importedIds: readonly string[]; dynamicallyImportedIds: readonly string[] } | null
}

/** Packages that every page needs. */
const EVERYWHERE =
  /\/(node_modules\/(react|react-dom|scheduler|use-sync-external-store|clsx|openapi-fetch|@tanstack\/(react-router|router-core|history|react-store|store|react-query|query-core)|@mantine\/core\/esm\/core|@mantine\/hooks\/esm\/(utils|use-(id|isomorphic-effect|media-query|color-scheme|uncontrolled|merged-ref)))\/|preload-helper)/
/** Mantine's fields, which most pages with a form need. */
const FIELDS =
  /@mantine\/core\/esm\/(components|utils)\/(Input|InputBase|InputClearButton|TextInput|Textarea|InlineInput|Checkbox|CheckIcon|CloseButton|UnstyledButton|Loader)\//
/** What fewer pages share goes with each of them: a request over a slow connection costs as much as 30 kB. */
const SHARED_BY = 3
const PARTS = /\/src\/(api|app|ui)\//
/** What the pages share on which sounds are made and judged. */
const WORK = /\/src\/(audio|judging|money)\//
/** The page that plays and measures sounds, and on which nobody judges: it loads nothing of verdicts. */
const DESK = /\/src\/features\/desk\/DeskPage\.tsx$/
/** What the desk and a version's page share, and those on which sounds are judged do not need. */
const FIXING = /\/src\/fixing\//
/** Where people arrive, with nothing in the browser's cache: these load no part that only other pages share. */
const ARRIVAL = /\/src\/features\/(accounts\/SignInPage|today\/TodayPage|review\/ReviewPage|desk\/DeskPage)\.tsx$/

const isOurs = (id: string) => id.includes('/src/') && !id.includes('node_modules')

/** Our modules that come with these. */
function reachedFrom(starts: readonly string[], graph: ModuleGraph): Set<string> {
  const reached = new Set<string>()
  const visit = (id: string) => {
    if (!isOurs(id) || reached.has(id)) return
    reached.add(id)
    graph.getModuleInfo(id)?.importedIds.forEach(visit)
  }
  starts.forEach(visit)
  return reached
}

/** Menus, dialogs and lists of Mantine are large, and loaded when they are asked for. */
const drawsInMantine = (id: string, graph: ModuleGraph): boolean =>
  [...reachedFrom([id], graph)].some((one) =>
    graph.getModuleInfo(one)?.importedIds.some((imported) => imported.includes('@mantine/core')),
  )

/** Name the file that a module goes to: one that every page needs, one that many share, or one as the bundler sees fit. */
export function chunkNames(main: string): (id: string, graph: ModuleGraph) => string | null {
  let names: Map<string, string> | undefined
  const nameAll = (graph: ModuleGraph) => {
    const base = reachedFrom([main], graph)
    base.delete(main) // the entry stays one of its own, so that the page has something to start
    const pages = new Set([...base].flatMap((id) => graph.getModuleInfo(id)?.dynamicallyImportedIds ?? []))
    const desk = reachedFrom(
      [...pages].filter((id) => DESK.test(id)),
      graph,
    )
    const arrivals = reachedFrom(
      [...pages].filter((id) => ARRIVAL.test(id)),
      graph,
    )
    const sharers = new Map<string, number>()
    for (const page of pages) {
      for (const id of reachedFrom([page], graph)) sharers.set(id, (sharers.get(id) ?? 0) + 1)
    }
    const names = new Map([...base].map((id) => [id, 'base']))
    for (const [id, count] of sharers) {
      if (count === 1 || base.has(id) || drawsInMantine(id, graph)) continue
      if (FIXING.test(id)) names.set(id, 'fixing')
      else if (WORK.test(id)) names.set(id, desk.has(id) ? 'work' : 'verdicts')
      else if (count >= SHARED_BY && PARTS.test(id)) names.set(id, arrivals.has(id) ? 'parts' : 'tools')
    }
    return names
  }
  return (id, graph) => {
    if (EVERYWHERE.test(id)) return 'base'
    if (FIELDS.test(id)) return 'fields'
    names ??= nameAll(graph)
    return names.get(id) ?? null
  }
}
