/** The arrows of the frontend: features stand on app, uploads, audio, ui and api, and never on one another. */
const lower = {
  api: 'app|audio|verdicts|losses|mending|ui|uploads|parts',
  ui: 'app|api|audio|verdicts|losses|mending|uploads|parts',
  audio: 'app|api|verdicts|losses|mending|uploads|parts',
  uploads: 'app|audio|verdicts|losses|mending|ui|parts',
  verdicts: 'losses|mending|uploads|parts',
  losses: 'app|verdicts|mending|money|uploads|parts',
  money: 'app|audio|verdicts|losses|mending|uploads|parts',
  mending: 'losses|uploads|parts',
  precheck: 'app|audio|losses|mending|money|ui|uploads|parts',
}

module.exports = {
  forbidden: [
    { name: 'no-circular', severity: 'error', from: {}, to: { circular: true } },
    {
      name: 'feature-to-feature',
      severity: 'error',
      from: { path: '^src/features/([^/]+)/' },
      to: { path: '^src/features/([^/]+)/', pathNot: '^src/features/$1/' },
    },
    {
      name: 'only-the-router-knows-features',
      severity: 'error',
      from: { pathNot: '^src/(features/|app/router\\.tsx$)' },
      to: { path: '^src/features/' },
    },
    {
      name: 'features-never-import-the-router',
      severity: 'error',
      from: { path: '^src/features/', pathNot: '\\.test\\.tsx?$' },
      to: { path: '^src/app/router\\.tsx$' },
    },
    ...Object.entries(lower).map(([part, above]) => ({
      name: `${part}-stands-below`,
      severity: 'error',
      from: { path: `^src/${part}/` },
      // a part says what was refused: it knows the shape of a refusal
      to: { path: `^src/(${above})/`, pathNot: '^src/api/problem\\.ts$' },
    })),
    {
      name: 'parts-page-stays-out-of-the-product',
      severity: 'error',
      from: { pathNot: '^src/(parts/|app/router\\.tsx$)' },
      to: { path: '^src/parts/' },
    },
    {
      name: 'tests-are-not-imported',
      severity: 'error',
      from: { pathNot: '(\\.test\\.tsx?$|^src/test/)' },
      to: { path: '(\\.test\\.tsx?$|^src/test/)' },
    },
    {
      name: 'no-orphans',
      severity: 'error',
      from: { orphan: true, pathNot: '(\\.d\\.ts$|\\.test\\.tsx?$|^src/test/setup\\.ts$|\\.css$)' },
      to: {},
    },
    {
      name: 'not-to-dev-dep',
      severity: 'error',
      from: { path: '^src', pathNot: '(\\.test\\.tsx?$|^src/test/)' },
      to: { dependencyTypes: ['npm-dev'], dependencyTypesNot: ['type-only'] },
    },
  ],
  options: {
    doNotFollow: { path: 'node_modules' },
    tsConfig: { fileName: 'tsconfig.json' },
    tsPreCompilationDeps: true,
    enhancedResolveOptions: {
      exportsFields: ['exports'],
      conditionNames: ['import', 'require', 'node', 'default', 'types'],
    },
  },
}
